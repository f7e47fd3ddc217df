#pragma once

#include <numbers>

#include "beadswim/collinear/pair_mobility.hpp"

// Oseen pair mobility of two spheres on their common line.
//
//   mu(r) = 1 / (4 pi eta r),   d mu / d r = -1 / (4 pi eta r^2)
//
//   r    distance of the centres [length]
//   eta  dynamic viscosity [mass/(length time)]
//
// mu is the longitudinal component of the Oseen tensor (I + rr/r^2) / (8 pi eta r). Each sphere acts on the
// other as a point force, so the law does not depend on the radii. It is valid for r >> a_i, a_j. Its error
// is of order (a/r)^3 relative to the Stokes mobility of a lone sphere.
//
// References: Pickl et al., J. Phys.: Condens. Matter 29, 124001 (2017), first term of eq. (4.13); Kim and
// Karrila, Microhydrodynamics (1991), chapter 2. Page: docs/method/oseen.md.

namespace beadswim {

/// Evaluates the Oseen mobility of two spheres along their common line, and its slope. `distance`: of the
/// centres [length], `viscosity`: dynamic [mass/(length time)]. The radii are ignored.
inline PairMobility oseen(double /*radius_i*/, double /*radius_j*/, double distance, double viscosity) {
  const double value = 1 / (4 * std::numbers::pi * viscosity * distance);
  return {.value = value, .slope = -value / distance};
}

}  // namespace beadswim
