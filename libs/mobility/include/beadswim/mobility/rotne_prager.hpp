#pragma once

#include <numbers>

#include "beadswim/mobility/pair_mobility.hpp"

// Rotne-Prager pair mobility of two spheres of any radii on their common line.
//
//   mu(r)     = 1 / (4 pi eta r)   -  (a_i^2 + a_j^2) / (12 pi eta r^3)
//   d mu / dr = -1 / (4 pi eta r^2) + (a_i^2 + a_j^2) / (4 pi eta r^4)
//
// a_i, a_j  radii [length]
// r         distance of the centres [length]
// eta       dynamic viscosity [mass/(length time)]
//
// The longitudinal part of the Oseen tensor plus (a_i^2 + a_j^2) / (24 pi eta r^3) (I - 3 rr/r^2): a Faxen
// correction for the finite size of either sphere. Holds for spheres apart, r >= a_i + a_j; overlapping
// spheres follow another branch of the law, which is not here. Its error is of order (a/r)^4 relative to the
// Stokes mobility of a lone sphere; self-mobilities stay those of lone spheres.
//
// References: Rotne and Prager, J. Chem. Phys. 50, 4831 (1969), and Yamakawa, J. Chem. Phys. 53, 436 (1970),
// for equal radii; Zuk, Wajnryb, Mizerski and Szymczak, J. Fluid Mech. 741, R5 (2014), the branch
// r > a_i + a_j, for unequal ones; Pickl et al., J. Phys.: Condens. Matter 29, 124001 (2017), eq. (4.13) with
// a_i^2 + a_j^2 for its a_i + a_j. Page: docs/method/rotne-prager.md.

namespace beadswim {

inline PairMobility rotne_prager(double radius_i, double radius_j, double distance, double viscosity) {
  const double oseen_value = 1 / (4 * std::numbers::pi * viscosity * distance);
  const double size = (radius_i * radius_i + radius_j * radius_j) / (distance * distance);
  return {.value = oseen_value * (1 - size / 3), .slope = -oseen_value / distance * (1 - size)};
}

}  // namespace beadswim
