#pragma once

#include "beadswim/core/kernel.hpp"
#include "beadswim/lattice/d3q19.hpp"

// Partially saturated cells: the force between fluid and bead in a cell. The bead fills a fraction of the
// cell.
//
//   F      = sigma (u_b - v),   v = u + F/2              so that  F = s (u_b - u),  s = sigma/(1 + sigma/2)
//   sigma  = 3 nu k(eps),       k(eps) = 11/2 eps/(11/10 - eps)
//   f_i   += e_i(u + F) - e_i(u)
//
// F: momentum that the fluid in the cell gains in the step; u: momentum that streams into the cell; v: mean
// of the momentum over the step; u_b: velocity of the bead at the cell; eps: fraction of the cell that the
// bead fills; k: resistance; nu: kinematic viscosity; sigma, s: coupling rates [1/step], 0 <= s < 2; e_i:
// equilibrium (trt.hpp).
//
// With the relaxation rates of trt.hpp, a steady slow flow depends on the viscosity and on sigma only through
// sigma/(3 nu) = k. Because k depends on eps alone, the drag divided by the viscosity is the same at every
// viscosity. The two constants in k were fitted to the drag of spheres (docs/method/saturated-cells.md).
//
// The term e_i(u + F) - e_i(u) changes f_i and its equilibrium equally. It may therefore be added before or
// after the collision with the same result. The collision is the same as in cells without beads.
//
// Noble & Torczynski, Int. J. Mod. Phys. C 9 (1998) 1189: superpose the collisions of fluid and solid with a
// weight B; s corresponds to B but follows from another law. Kupershtokh, Medvedev & Karpov, Comput. Math.
// Appl. 58 (2009) 965: the force term.

namespace beadswim {

// The type Value is double, or a vector of doubles with one lane per cell.

/// Returns the resistance k(eps) of a cell, where eps is the fraction of the cell that a bead fills.
template <class Value>
BEADSWIM_KERNEL Value resistance(Value solid_fraction) {
  constexpr double strength = 11.0 / 2, sharpness = 11.0 / 10;
  return strength * solid_fraction / (sharpness - solid_fraction);
}

/// Returns the coupling rate s = sigma/(1 + sigma/2), for which the force on the fluid is F = s (u_b - u).
template <class Value>
BEADSWIM_KERNEL Value forcing_rate(Value sigma) {
  return sigma / (1 + sigma / 2);
}

/// Returns e_i(u_new) - e_i(u_old), the change of the equilibrium population of direction i if the momentum
/// changes from u_old to u_new. squares: u_new^2 - u_old^2.
template <class Value>
BEADSWIM_KERNEL Value equilibrium_change(int i, const Value (&u_old)[3], const Value (&u_new)[3],
                                         Value squares) {
  Value cu_old{}, cu_new{};
#pragma GCC unroll 3
  for (int a = 0; a < 3; ++a) {
    const int c = d3q19::velocity[i][a];
    if (c == 1) cu_old += u_old[a], cu_new += u_new[a];
    if (c == -1) cu_old -= u_old[a], cu_new -= u_new[a];
  }
  return d3q19::weight(i) * ((cu_new - cu_old) * (3 + 4.5 * (cu_new + cu_old)) - 1.5 * squares);
}

/// Returns u_new^2 - u_old^2.
template <class Value>
BEADSWIM_KERNEL Value squares_difference(const Value (&u_old)[3], const Value (&u_new)[3]) {
  Value sum{};
#pragma GCC unroll 3
  for (int a = 0; a < 3; ++a) sum += (u_new[a] - u_old[a]) * (u_new[a] + u_old[a]);
  return sum;
}

}  // namespace beadswim
