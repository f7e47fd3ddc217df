#pragma once

#include <numbers>

#include "beadswim/collinear/pair_mobility.hpp"

// Oseen mobility of two spheres: the tensor (I + rr/r^2) / (8 pi eta r), and its component along the line of
// centres
//
//   mu(r) = 1 / (4 pi eta r),   d mu / d r = -1 / (4 pi eta r^2)
//
//   r    distance of the centres [length]
//   eta  dynamic viscosity [mass/(length time)]
//
// Each sphere acts on the other as a point force, so the law does not depend on the radii. It is valid for
// r >> a_i, a_j. Its error is of order (a/r)^3 relative to the Stokes mobility of a lone sphere.
//
// References: Pickl et al., J. Phys.: Condens. Matter 29, 124001 (2017), first term of eq. (4.13); Kim and
// Karrila, Microhydrodynamics (1991), chapter 2. Page: docs/method/oseen.md.

namespace beadswim {

/// Evaluates the Oseen tensor of two point forces at the distance r [length]. The radii are ignored.
inline PairTensor oseen_pairs(double /*radius_i*/, double /*radius_j*/, double r, double eta) {
  const double oseen = 1 / (8 * std::numbers::pi * eta * r);
  return {.isotropic = oseen, .axial = oseen};
}

/// Evaluates the component of the Oseen tensor along the line of centres, and its slope.
inline PairMobility oseen(double radius_i, double radius_j, double r, double eta) {
  return along_line(oseen_pairs(radius_i, radius_j, r, eta), r);
}

}  // namespace beadswim
