#pragma once

#include <complex>
#include <vector>

#include "beadswim/collinear/periodic_stokes.hpp"
#include "beadswim/collinear/unsteady_stokes.hpp"

// clang-format off
// Unsteady Stokes flow of a periodic lattice of oscillating forces along x: velocity along x on the line of
// the forces, per force. alpha^2 = i omega rho / eta. The flow and its two parts have these Fourier
// transforms:
//
//   helmholtz  (1/eta) (1 + k_x^2/alpha^2) / (k^2 + alpha^2)    with k = 0: 1/(eta alpha^2 V), uniform flow
//   harmonic   (1/eta) ( -  k_x^2/alpha^2) /  k^2               without k = 0
//   total      (1/eta) (1 - k_x^2/k^2)     / (k^2 + alpha^2)    with k = 0
//
// The harmonic part follows from the steady velocity per force, G_xx (periodic_stokes.hpp). With n copies of
// the force in the lattice cell of volume V:
//
//   eta alpha^2 harmonic = n/V - eta laplacian of the steady G_xx
//
// The helmholtz part and the total are evaluated as Ewald sums of the integrals
//
//   helmholtz  (1/eta) integral_0^oo [ e^{-alpha^2 s} g_s - (e^{-alpha^2 s}/alpha^2) d^2 g_s/dx^2 ] ds
//   total      (1/eta) integral_0^oo [ e^{-alpha^2 s} g_s +                    q(s)  d^2 g_s/dx^2 ] ds
//
//   g_s(r) = (4 pi s)^{-3/2} exp(-r^2/4s), the heat kernel;   q(s) = (1 - e^{-alpha^2 s})/alpha^2;   tau = 1/(4 xi^2)
// clang-format on
//
// The integrals over s > tau are evaluated as sums over wavevectors. The integrals over s < tau are evaluated
// as sums over images, with Gauss-Legendre quadrature in s. No term is larger than the sum, so the total
// suffers no loss of significance as alpha -> 0. If |alpha| V_box^{1/3} > 13, where V_box is the volume of
// the box, the helmholtz flow of an image decays within the box. The helmholtz part is then summed directly
// over images.
//
// Page: docs/method/unsteady-stokes.md.

namespace beadswim {

class PeriodicUnsteadyStokes {
 public:
  /// Sets up the flow of oscillating forces. `steady` is the steady flow of the same lattice; a reference to
  /// it is stored. Requires alpha [1/length] != 0 and |arg alpha| <= pi/4.
  PeriodicUnsteadyStokes(const PeriodicStokes& steady, std::complex<double> alpha);

  /// Evaluates the unsteady velocity per force on the line of the forces. `displacement` [length] is measured
  /// along the line from a force, and must not be a multiple of the period.
  UnsteadyLine at(double displacement) const;

  /// Evaluates the unsteady velocity that all images of a force cause at the position of the force, per
  /// force. The singular flow of the force itself is left out.
  UnsteadyLine images() const;

 private:
  struct WaveSum {
    std::complex<double> helmholtz, total;
  };
  struct Parts {
    LineValue<std::complex<double>> helmholtz, total;
  };

  bool decays_within_box() const;
  LineValue<std::complex<double>> harmonic(const LineValue<double>& steady_laplacian) const;
  UnsteadyLine flow(double displacement, const LineValue<double>& steady_laplacian) const;
  Parts ewald_sum(double displacement) const;
  Parts waves(double displacement) const;
  Parts near_images(double displacement) const;
  Parts self_flow_of_waves() const;
  LineValue<std::complex<double>> helmholtz_images(double displacement) const;

  const PeriodicStokes& steady_;
  std::complex<double> alpha_;
  std::vector<WaveSum> wave_sums_;   ///< sums over k_y and k_z for each k_x = 2 pi n/period, n = 0, 1, ...
  std::vector<double> image_lines_;  ///< squared distances of the image lines within cutoff_ [length^2]
  double cutoff_ = 0;                ///< distance up to which images are summed [length]
};

}  // namespace beadswim
