#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

#include "beadswim/collinear/pair_mobility.hpp"

// clang-format off
// Rotne-Prager pair mobility of two spheres of any radii along their common line. The spheres may overlap.
//
//   apart            a_i + a_j <= r           mu     =   [1 - A/(3 r^2)] / (4 pi eta r)
//                                             dmu/dr = - [1 - A/r^2]     / (4 pi eta r^2)
//
//   overlapping      |D| < r < a_i + a_j      mu     =   [(a_i + a_j)/2 + r (D^4/r^4 - 6 D^2/r^2 - 3)/16] / (6 pi eta a_i a_j)
//                                             dmu/dr = - 3 (1 - D^2/r^2)^2 / 16                           / (6 pi eta a_i a_j)
//
//   one inside the other     r <= |D|         mu     =   1 / (6 pi eta max(a_i, a_j)),    dmu/dr = 0
//
//   a_i, a_j  radii [length];  A = a_i^2 + a_j^2,  D = a_i - a_j
//   r         distance of the centres [length]
//   eta       dynamic viscosity [mass/(length time)]
//   mu        velocity of one sphere per force on the other [time/mass]
//
// mu is the longitudinal component of the Oseen tensor, averaged over the surfaces of both spheres. Value and
// slope are continuous at r = a_i + a_j and r = |D|. For spheres that do not overlap, the average adds
// Faxen's correction A / (24 pi eta r^3) (I - 3 rr/r^2) to the Oseen tensor. The error of mu is then of order
// (a/r)^4, relative to the Stokes mobility of a lone sphere. Self-mobilities are the mobilities of lone
// spheres. For overlapping spheres the law does not describe a flow between two spheres, but it keeps the
// dissipation positive.
// clang-format on
//
// References: Rotne and Prager, J. Chem. Phys. 50, 4831 (1969), and Yamakawa, J. Chem. Phys. 53, 436 (1970),
// for equal radii; Zuk, Wajnryb, Mizerski and Szymczak, J. Fluid Mech. 741, R5 (2014), for unequal radii;
// Pickl et al., J. Phys.: Condens. Matter 29, 124001 (2017), eq. (4.13), in which a_i + a_j is replaced by
// a_i^2 + a_j^2 here. Page: docs/method/rotne-prager.md.

namespace beadswim {

// clang-format off
/// Evaluates the Rotne-Prager mobility along the line of centres, and its slope, for spheres that do not
/// overlap: r >= a_i + a_j. Radii a_i, a_j and distance r of the centres in [length], dynamic viscosity eta
/// in [mass/(length time)].
inline PairMobility rotne_prager_apart(double a_i, double a_j, double r, double eta) {
  const double oseen = 1 / (4 * std::numbers::pi * eta * r);
  const double size  = (a_i * a_i + a_j * a_j) / (r * r);  // A/r^2
  return {.value =  oseen     * (1 - size / 3),
          .slope = -oseen / r * (1 - size)};
}

/// Evaluates the Rotne-Prager mobility along the line of centres, and its slope, for spheres whose surfaces
/// intersect: |a_i - a_j| < r < a_i + a_j, where r is the distance of the centres.
inline PairMobility rotne_prager_overlapping(double a_i, double a_j, double r, double eta) {
  const double unit = 1 / (6 * std::numbers::pi * eta * a_i * a_j);
  const double D_r  = (a_i - a_j) / r;  // D/r
  const double d2   = D_r * D_r;        // D^2/r^2
  return {.value =  unit * ((a_i + a_j) / 2 + r * (d2 * d2 - 6 * d2 - 3) / 16),
          .slope = -unit * 3 * (1 - d2) * (1 - d2) / 16};
}

/// Evaluates the Rotne-Prager mobility along the line of centres, and its slope, at any distance r of the
/// centres [length], for radii a_i, a_j [length] and dynamic viscosity eta [mass/(length time)].
inline PairMobility rotne_prager(double a_i, double a_j, double r, double eta) {
  if (r >= a_i + a_j)          return rotne_prager_apart(a_i, a_j, r, eta);
  if (r > std::abs(a_i - a_j)) return rotne_prager_overlapping(a_i, a_j, r, eta);
  return {.value = self_mobility(std::max(a_i, a_j), eta), .slope = 0};
}
// clang-format on

}  // namespace beadswim
