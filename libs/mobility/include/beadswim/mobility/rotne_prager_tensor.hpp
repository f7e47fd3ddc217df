#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

#include "beadswim/collinear/pair_mobility.hpp"
#include "beadswim/core/vec3.hpp"

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
// mu is the Oseen tensor averaged over both surfaces. The mobility matrix of any number of spheres at any
// positions is positive definite. The component of mu along the line of centres is the law of
// rotne_prager.hpp.
//
// Reference: Zuk, Wajnryb, Mizerski and Szymczak, J. Fluid Mech. 741, R5 (2014). Page:
// docs/method/rotne-prager.md.
// clang-format on

namespace beadswim {

/// Mobility tensor of two spheres, isotropic I + axial n n^T [time/mass], where I is the unit tensor and n
/// the unit vector along the line of centres.
struct PairTensor {
  double isotropic = 0, axial = 0;

  PairTensor operator-(const PairTensor& other) const {
    return {isotropic - other.isotropic, axial - other.axial};
  }
  /// Returns the velocity that `force` on one sphere gives to the other sphere. `separation` is the vector
  /// between the centres, `distance` its length.
  Vec3 apply(const Vec3& separation, double distance, const Vec3& force) const {
    if (distance == 0) return isotropic * force;
    return isotropic * force + (axial * separation.dot(force) / (distance * distance)) * separation;
  }
};

// clang-format off
/// Evaluates the Oseen tensor (I + rr/r^2)/(8 pi eta r), the mobility tensor of two point forces at the
/// distance r [length].
inline PairTensor oseen_tensor(double r, double eta) {
  const double oseen = 1 / (8 * std::numbers::pi * eta * r);
  return {.isotropic = oseen, .axial = oseen};
}

/// Evaluates oseen_tensor() with the arguments of rotne_prager_tensor(), of which the radii are ignored.
inline PairTensor oseen_pairs(double /*a_i*/, double /*a_j*/, double r, double eta) {
  return oseen_tensor(r, eta);
}

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

}  // namespace beadswim
