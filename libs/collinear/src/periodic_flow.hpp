#pragma once

#include "periodic_line.hpp"

// Flow of a periodic lattice of forces along x: velocity along x on the line of the forces, per force. The
// argument `displacement` [length] is measured along the line from a force, and must not be a multiple of the
// period. images() evaluates the flow that all images of a force cause at the position of the force; the
// singular flow of the force itself is left out. For each k_x, the sum over k_y and k_z does not depend on
// the positions on the line, so it is computed once. Pages: docs/method/boxes.md,
// docs/method/unsteady-stokes.md.

namespace beadswim {

/// Steady flow in fluid of the dynamic `viscosity` [mass/(length time)].
class PeriodicStokes {
 public:
  PeriodicStokes(double viscosity, const PeriodicLine& line);

  SteadyFlow at(double displacement) const;
  SteadyFlow images() const;

  const PeriodicLine& line() const { return line_; }
  double viscosity() const { return viscosity_; }

 private:
  double viscosity_;
  PeriodicLine line_;
  WaveAmplitudes<double> waves_;     ///< of SteadyFlow::oseen and laplacian
  std::vector<double> image_lines_;  ///< squared distances of the image lines [length^2]
};

/// Flow of forces that oscillate as exp(i omega t), alpha = sqrt(i omega rho/eta) [1/length].
class PeriodicUnsteadyStokes {
 public:
  /// `steady` is the steady flow of the same lattice; a reference to it is stored. Requires alpha != 0 and
  /// |arg alpha| <= pi/4.
  PeriodicUnsteadyStokes(const PeriodicStokes& steady, Complex alpha);

  UnsteadyFlow at(double displacement) const;
  UnsteadyFlow images() const;

 private:
  /// Helmholtz part and total of the flow.
  using Parts = std::array<LineKernel<Complex>, 2>;

  bool decays_within_box() const;
  UnsteadyFlow flow(double displacement, const LineKernel<double>& steady_laplacian) const;
  Parts near_images(double displacement) const;
  Parts self_flow_of_waves() const;
  LineKernel<Complex> helmholtz_images(double displacement) const;

  const PeriodicStokes& steady_;
  Complex alpha_;
  WaveAmplitudes<Complex> waves_;    ///< of the Helmholtz part and the total
  double cutoff_;                    ///< distance up to which images are summed [length]
  std::vector<double> image_lines_;  ///< squared distances of the image lines within cutoff_ [length^2]
};

}  // namespace beadswim
