#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

#include "beadswim/collinear/pair_mobility.hpp"

// clang-format off
// Rotne-Prager-Yamakawa mobility of two spheres of any radii in open space. The spheres may overlap:
//
//   mu = isotropic I + axial rr/r^2,     A = a_i^2 + a_j^2,  D = a_i - a_j
//
//   isotropic = (1 + A/(3 r^2)) / (8 pi eta r)             axial = (1 - A/r^2) / (8 pi eta r)    apart
//   isotropic = u [16 r^3 (a_i + a_j) - (D^2 + 3 r^2)^2]   axial = u 3 (D^2 - r^2)^2             overlapping
//   isotropic = 1/(6 pi eta max(a_i, a_j))                 axial = 0                             one in the other
//
//   a_i, a_j  radii, r distance of the centres [length];  u = 1/(192 pi eta a_i a_j r^3)
//   eta       dynamic viscosity [mass/(length time)]
//   mu        velocity of one sphere per force on the other [time/mass]
//
// mu is the Oseen tensor averaged over both surfaces, of which value and slope are continuous at r = a_i + a_j and
// r = |D|. The mobility matrix of any number of spheres at any positions is positive definite. Self-mobilities are
// those of lone spheres. For spheres that do not overlap, the average adds Faxen's correction
// A / (24 pi eta r^3) (I - 3 rr/r^2) to the Oseen tensor. The error of mu is then of order (a/r)^4, relative to the
// Stokes mobility of a lone sphere. For overlapping spheres the law does not describe a flow between two spheres, but
// it keeps the dissipation positive.
// clang-format on
//
// References: Rotne and Prager, J. Chem. Phys. 50, 4831 (1969), and Yamakawa, J. Chem. Phys. 53, 436 (1970),
// for equal radii; Zuk, Wajnryb, Mizerski and Szymczak, J. Fluid Mech. 741, R5 (2014), for unequal radii;
// Pickl et al., J. Phys.: Condens. Matter 29, 124001 (2017), eq. (4.13), in which a_i + a_j is replaced by
// a_i^2 + a_j^2 here. Page: docs/method/rotne-prager.md.

namespace beadswim {

// clang-format off
/// Evaluates the Rotne-Prager formula for spheres that do not overlap. Distances r < a_i + a_j, for which it
/// is not the mobility, are allowed. `squared_radii` is a_i^2 + a_j^2 for the radii a_i and a_j [length^2].
inline PairTensor rotne_prager_tensor_apart(double squared_radii, double r, double eta) {
  const double oseen = 1 / (8 * std::numbers::pi * eta * r);
  const double size  = squared_radii / (r * r);  // A/r^2
  return {.isotropic = oseen * (1 + size / 3),
          .axial     = oseen * (1 - size)};
}

/// Evaluates the Rotne-Prager mobility tensor of two spheres of radii a_i and a_j at any distance r of their
/// centres [length]. The spheres may overlap.
inline PairTensor rotne_prager_tensor(double a_i, double a_j, double r, double eta) {
  if (r >= a_i + a_j)           return rotne_prager_tensor_apart(a_i * a_i + a_j * a_j, r, eta);
  if (r <= std::abs(a_i - a_j)) return {.isotropic = self_mobility(std::max(a_i, a_j), eta), .axial = 0};
  const double D   = a_i - a_j;
  const double u   = 1 / (192 * std::numbers::pi * eta * a_i * a_j * r * r * r);
  const double sum = D * D + 3 * r * r, difference = D * D - r * r;
  return {.isotropic = u * (16 * r * r * r * (a_i + a_j) - sum * sum),
          .axial     = u * 3 * difference * difference};
}
// clang-format on

/// Evaluates the component of rotne_prager_tensor() along the line of centres, and its slope.
inline PairMobility rotne_prager(double a_i, double a_j, double r, double eta) {
  return along_line(rotne_prager_tensor(a_i, a_j, r, eta), r);
}

}  // namespace beadswim
