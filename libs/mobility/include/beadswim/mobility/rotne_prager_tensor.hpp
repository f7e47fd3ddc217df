#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

#include "beadswim/core/vec3.hpp"
#include "beadswim/mobility/pair_mobility.hpp"

// clang-format off
// Rotne-Prager-Yamakawa mobility of two spheres of any radii, apart or overlapping, in open space:
//
//   mu = isotropic I + axial rr/r^2,     A = a_i^2 + a_j^2,  D = a_i - a_j
//
//   isotropic = (1 + A/(3 r^2)) / (8 pi eta r)             axial = (1 - A/r^2) / (8 pi eta r)    apart
//   isotropic = u [16 r^3 (a_i + a_j) - (D^2 + 3 r^2)^2]   axial = u 3 (D^2 - r^2)^2             overlapping
//   isotropic = 1/(6 pi eta max(a_i, a_j))                 axial = 0                             one in the other
//
// with u = 1/(192 pi eta a_i a_j r^3). The Oseen tensor averaged over both surfaces: any number of spheres, wherever
// they are, has a positive definite mobility. Along the line of centres it is rotne_prager.hpp's.
//
// Reference: Zuk, Wajnryb, Mizerski and Szymczak, J. Fluid Mech. 741, R5 (2014). Page: docs/method/rotne-prager.md.
// clang-format on

namespace beadswim {

/// mu = isotropic I + axial n n^T, n along the line of centres [time/mass].
struct PairTensor {
  double isotropic = 0, axial = 0;

  PairTensor operator-(const PairTensor& other) const {
    return {isotropic - other.isotropic, axial - other.axial};
  }
  /// Velocity by a force, `separation` of length `distance` between the centres.
  Vec3 apply(const Vec3& separation, double distance, const Vec3& force) const {
    if (distance == 0) return isotropic * force;
    return isotropic * force + (axial * separation.dot(force) / (distance * distance)) * separation;
  }
};

/// What two point forces do: (I + rr/r^2) / (8 pi eta r).
inline PairTensor oseen_tensor(double distance, double viscosity) {
  const double value = 1 / (8 * std::numbers::pi * viscosity * distance);
  return {.isotropic = value, .axial = value};
}

/// The form for spheres apart, wherever they are; radii squared alone enter.
inline PairTensor rotne_prager_tensor_apart(double squared_radii, double distance, double viscosity) {
  const double value = 1 / (8 * std::numbers::pi * viscosity * distance);
  const double size = squared_radii / (distance * distance);
  return {.isotropic = value * (1 + size / 3), .axial = value * (1 - size)};
}

inline PairTensor rotne_prager_tensor(double radius_i, double radius_j, double distance, double viscosity) {
  const double r = distance, d = radius_i - radius_j;
  if (r >= radius_i + radius_j)
    return rotne_prager_tensor_apart(radius_i * radius_i + radius_j * radius_j, r, viscosity);
  if (r <= std::abs(d))
    return {.isotropic = self_mobility(std::max(radius_i, radius_j), viscosity), .axial = 0};
  const double unit = 1 / (192 * std::numbers::pi * viscosity * radius_i * radius_j * r * r * r);
  const double sum = d * d + 3 * r * r, difference = d * d - r * r;
  return {.isotropic = unit * (16 * r * r * r * (radius_i + radius_j) - sum * sum),
          .axial = unit * 3 * difference * difference};
}

}  // namespace beadswim
