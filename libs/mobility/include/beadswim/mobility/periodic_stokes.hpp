#pragma once

#include <vector>

#include "beadswim/mobility/line_kernel.hpp"
#include "beadswim/mobility/periodic_line.hpp"

// Steady Stokes flow of a periodic lattice of forces along x, along x on their line: Ewald's sum with
// Hasimoto's splitting. With H the biharmonic function, transform 1/k^4,
//
//   G_xx = (1/eta) (-d^2/dy^2 - d^2/dz^2) H,    1/k^4 = integral_0^oo s exp(-k^2 s) ds
//
// and the integral cut at s = 1/(4 xi^2): what is above decays in k, what is below in r,
//
//   waves:  (1/(eta V)) sum_{k != 0} (k_y^2 + k_z^2)/k^4 (1 + k^2/(4 xi^2)) exp(-k^2/(4 xi^2)) cos(k.d)
//   images: (1/(4 pi eta)) sum [ B_0 - rho^2 B_1/2 ]
//           B_0 = erfc(xi r)/r,  B_n = [ (2n - 1) B_{n-1} + (2 xi^2)^n/(xi sqrt(pi)) exp(-xi^2 r^2) ]/r^2
//
// V is the volume of the lattice cell, (x, rho) the receiver as seen from an image. The sum over k_y, k_z
// does not depend on the places on the line and is done once.
//
// References: Hasimoto, J. Fluid Mech. 5, 317 (1959); Beenakker, J. Chem. Phys. 85, 1581 (1986) for the
// Rotne-Prager tensor. Page: docs/method/boxes.md.

namespace beadswim {

/// G_xx and (1/6) laplacian of G_xx, as functions of the displacement along the line.
struct SteadyLine {
  LineValue<double> oseen, laplacian;
};

class PeriodicStokes {
 public:
  PeriodicStokes(double viscosity, const PeriodicLine& line);

  /// At a displacement that is not a multiple of the period.
  SteadyLine at(double displacement) const;

  /// At the source itself, without its own singular part.
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
  std::vector<WaveSum> wave_sums_;  ///< by wavenumber n 2 pi/period along x
  std::vector<double> image_lines_;
};

}  // namespace beadswim
