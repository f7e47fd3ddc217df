#pragma once

#include <vector>

#include "beadswim/collinear/line_kernel.hpp"
#include "beadswim/collinear/periodic_line.hpp"

// Steady Stokes flow of a periodic lattice of forces along x. The velocity along x per force, G_xx, is
// evaluated on the line of the forces by an Ewald sum with Hasimoto's splitting. For one force in unbounded
// fluid, G_xx follows from the biharmonic function H, whose Fourier transform is 1/k^4:
//
//   G_xx = (1/eta) (-d^2/dy^2 - d^2/dz^2) H,    1/k^4 = integral_0^oo s exp(-k^2 s) ds
//
// The integral is divided at s = 1/(4 xi^2). The part above this s gives a sum over wavevectors k, the part
// below it gives a sum over the images of the force. Both sums converge fast:
//
//   waves:  (1/(eta V)) sum_{k != 0} (k_y^2 + k_z^2)/k^4 (1 + k^2/(4 xi^2)) exp(-k^2/(4 xi^2)) cos(k.d)
//   images: (1/(4 pi eta)) sum [ B_0 - rho^2 B_1/2 ]
//           B_0 = erfc(xi r)/r,  B_n = [ (2n - 1) B_{n-1} + (2 xi^2)^n/(xi sqrt(pi)) exp(-xi^2 r^2) ]/r^2
//
// xi is the splitting parameter [1/length], V the volume of the lattice cell, and d the vector from the force
// to the receiver. (x, rho) is the vector from an image to the receiver, along and across the line, and r its
// length. For each k_x, the sum over k_y and k_z does not depend on the positions on the line, so it is
// computed once.
//
// References: Hasimoto, J. Fluid Mech. 5, 317 (1959); Beenakker, J. Chem. Phys. 85, 1581 (1986) for the
// Rotne-Prager tensor. Page: docs/method/boxes.md.

namespace beadswim {

/// Values of G_xx [time/mass] and of (1/6) laplacian G_xx [time/(mass length^2)] as functions of the
/// displacement along the line. G_xx is the steady velocity along x per force along x.
struct SteadyLine {
  LineValue<double> oseen, laplacian;
};

class PeriodicStokes {
 public:
  PeriodicStokes(double viscosity, const PeriodicLine& line);

  /// Evaluates the steady velocity per force on the line of the forces. `displacement` [length] is measured
  /// along the line from a force, and must not be a multiple of the period.
  SteadyLine at(double displacement) const;

  /// Evaluates the steady velocity that all images of a force cause at the position of the force, per force.
  /// The singular flow of the force itself is left out.
  SteadyLine images() const;

  const PeriodicLine& line() const { return line_; }
  double viscosity() const { return viscosity_; }

 private:
  struct WaveSum {
    double oseen, laplacian;
  };

  SteadyLine waves(double displacement) const;
  SteadyLine near_images(double displacement) const;

  double viscosity_;
  PeriodicLine line_;
  std::vector<WaveSum> wave_sums_;   ///< sums over k_y and k_z for each k_x = 2 pi n/period, n = 0, 1, ...
  std::vector<double> image_lines_;  ///< squared distances of the image lines [length^2]
};

}  // namespace beadswim
