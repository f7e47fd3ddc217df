#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

#include "beadswim/mobility/pair_mobility.hpp"

// Rotne-Prager pair mobility of two spheres of any radii on their common line, apart or overlapping.
//
//   mu(r) = 1 / (4 pi eta r) - (a_i^2 + a_j^2) / (12 pi eta r^3)                           a_i + a_j <= r
//   mu(r) = [(a_i + a_j)/2 + D^4/(16 r^3) - 3 D^2/(8 r) - 3 r/16] / (6 pi eta a_i a_j)     |D| < r < a_i +
//   a_j mu(r) = 1 / (6 pi eta max(a_i, a_j))                                                   r <= |D|
//
//   d mu / dr = -1 / (4 pi eta r^2) + (a_i^2 + a_j^2) / (4 pi eta r^4)
//   d mu / dr = -(1 - D^2/r^2)^2 / (32 pi eta a_i a_j)
//   d mu / dr = 0
//
// a_i, a_j  radii [length],  D = a_i - a_j
// r         distance of the centres [length]
// eta       dynamic viscosity [mass/(length time)]
//
// The longitudinal part of the Oseen tensor averaged over the surfaces of both spheres; value and slope are
// continuous where the branches meet. Apart, the average is Faxen's correction, (a_i^2 + a_j^2) /
// (24 pi eta r^3) (I - 3 rr/r^2), with an error of order (a/r)^4 relative to the Stokes mobility of a lone
// sphere; self-mobilities stay those of lone spheres. For overlapping spheres the law is no flow between
// spheres, but keeps dissipation positive.
//
// References: Rotne and Prager, J. Chem. Phys. 50, 4831 (1969), and Yamakawa, J. Chem. Phys. 53, 436 (1970),
// for equal radii; Zuk, Wajnryb, Mizerski and Szymczak, J. Fluid Mech. 741, R5 (2014), for unequal ones;
// Pickl et al., J. Phys.: Condens. Matter 29, 124001 (2017), eq. (4.13) with a_i^2 + a_j^2 for its a_i + a_j.
// Page: docs/method/rotne-prager.md.

namespace beadswim {

/// Spheres apart: r >= a_i + a_j.
inline PairMobility rotne_prager_apart(double radius_i, double radius_j, double distance, double viscosity) {
  const double oseen_value = 1 / (4 * std::numbers::pi * viscosity * distance);
  const double size = (radius_i * radius_i + radius_j * radius_j) / (distance * distance);
  return {.value = oseen_value * (1 - size / 3), .slope = -oseen_value / distance * (1 - size)};
}

/// Surfaces that cut each other: |a_i - a_j| < r < a_i + a_j.
inline PairMobility rotne_prager_overlapping(double radius_i, double radius_j, double distance,
                                             double viscosity) {
  const double unit = 1 / (6 * std::numbers::pi * viscosity * radius_i * radius_j);
  const double ratio = (radius_i - radius_j) / distance;  // D/r
  const double d2 = ratio * ratio;
  const double mean_radius = (radius_i + radius_j) / 2;
  return {.value = unit * (mean_radius + distance * (d2 * d2 - 6 * d2 - 3) / 16),
          .slope = -unit * 3 * (1 - d2) * (1 - d2) / 16};
}

inline PairMobility rotne_prager(double radius_i, double radius_j, double distance, double viscosity) {
  if (distance >= radius_i + radius_j) {
    return rotne_prager_apart(radius_i, radius_j, distance, viscosity);
  }
  if (distance > std::abs(radius_i - radius_j)) {
    return rotne_prager_overlapping(radius_i, radius_j, distance, viscosity);
  }
  return {.value = self_mobility(std::max(radius_i, radius_j), viscosity),
          .slope = 0};  // one holds the other
}

}  // namespace beadswim
