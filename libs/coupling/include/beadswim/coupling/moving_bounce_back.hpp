#pragma once

#include "beadswim/coupling/bead_on_lattice.hpp"
#include "beadswim/lattice/d3q19.hpp"

// Half-way bounce-back off a moving wall, and the momentum that it hands over, for one link.
//
//   f_ibar(x, t+1) = f_i*(x, t) - 6 w_i c_i.u_w          i points from the fluid cell x into the bead
//   impulse        = c_i (f_i*(x, t) + f_ibar(x, t+1))
//
// u_w: velocity of the bead half-way along the link. f: deviations from w_i; the pressure of the resting
// fluid is thereby left out, which on a closed surface sums to nothing. Lattice units, mean density 1.
//
// Ladd, J. Fluid Mech. 271 (1994) 285, eqs (3.2)-(3.3); Aidun, Lu & Ding, J. Fluid Mech. 373 (1998) 287.

namespace beadswim {

/// c_i.u_w
inline double approach_speed(int i, const Vec3& wall_velocity) {
  const auto& c = d3q19::velocity[i];
  return c[0] * wall_velocity[0] + c[1] * wall_velocity[1] + c[2] * wall_velocity[2];
}

/// What comes back along ibar when `outgoing` leaves along i.
inline double bounced(int i, double outgoing, const Vec3& wall_velocity) {
  return outgoing - 6 * d3q19::weight(i) * approach_speed(i, wall_velocity);
}

/// Momentum that the link hands to the bead in one step.
inline Vec3 link_impulse(int i, double outgoing, double returned) {
  const auto& c = d3q19::velocity[i];
  return (outgoing + returned) * Vec3(c[0], c[1], c[2]);
}

/// Share of one link in the density around a covered cell: w_i r = f_i* - 3 w_i c_i.u_w to first order.
inline double weighted_density_deviation(int i, double outgoing, const Vec3& wall_velocity) {
  return outgoing - 3 * d3q19::weight(i) * approach_speed(i, wall_velocity);
}

}  // namespace beadswim
