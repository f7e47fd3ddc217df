#pragma once

#include <vector>

#include "beadswim/mobility/line_kernel.hpp"
#include "beadswim/mobility/periodic_line.hpp"

// Steady Stokes flow of a periodic lattice of forces along x: velocity along x on their line, by an Ewald sum
// with Hasimoto's splitting. H is the biharmonic function with the transform 1/k^4:
//
//   G_xx = (1/eta) (-d^2/dy^2 - d^2/dz^2) H,    1/k^4 = integral_0^oo s exp(-k^2 s) ds
//
// The integral is divided at s = 1/(4 xi^2). The upper part decays in k, the lower part in r:
//
//   waves:  (1/(eta V)) sum_{k != 0} (k_y^2 + k_z^2)/k^4 (1 + k^2/(4 xi^2)) exp(-k^2/(4 xi^2)) cos(k.d)
//   images: (1/(4 pi eta)) sum [ B_0 - rho^2 B_1/2 ]
//           B_0 = erfc(xi r)/r,  B_n = [ (2n - 1) B_{n-1} + (2 xi^2)^n/(xi sqrt(pi)) exp(-xi^2 r^2) ]/r^2
//
// V is the volume of the lattice cell, (x, rho) the position of the receiver relative to an image. The sum
// over k_y and k_z does not depend on the positions on the line. It is computed once.
//
// References: Hasimoto, J. Fluid Mech. 5, 317 (1959); Beenakker, J. Chem. Phys. 85, 1581 (1986) for the
// Rotne-Prager tensor. Page: docs/method/boxes.md.

namespace beadswim {

/// G_xx [time/mass] and (1/6) laplacian of G_xx [time/(mass length^2)], as functions of the displacement on
/// the line.
struct SteadyLine {
  LineValue<double> oseen, laplacian;
};

class PeriodicStokes {
 public:
  PeriodicStokes(double viscosity, const PeriodicLine& line);

  /// Evaluates the flow at a displacement [length] that is not a multiple of the period.
  SteadyLine at(double displacement) const;

  /// Evaluates the flow at the source by all its images, without the singular flow of the source itself.
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
  std::vector<WaveSum> wave_sums_;   ///< per wavenumber n 2 pi/period along x
  std::vector<double> image_lines_;  ///< squared distances of the image lines [length^2]
};

}  // namespace beadswim
