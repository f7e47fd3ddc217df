#pragma once

#include "beadswim/core/kernel.hpp"

// Half-way bounce-back off a moving wall, and the momentum that it hands over, for one link.
//
//   f_ibar(x, t+1) = f_i*(x, t) - 6 w_i c_i.u_w          i points from the fluid cell x into the bead
//   impulse        = c_i (f_i*(x, t) + f_ibar(x, t+1))
//
// u_w: velocity of the bead half-way along the link. f: deviations from w_i; the pressure of the resting
// fluid is thereby left out, which on a closed surface sums to nothing. Lattice units, mean density 1.
//
// With r from the bead's centre to the covered cell at the link's end, u_w = v + omega x (r - c_i/2), of
// which c_i/2 gives nothing along c_i, nor to the angular impulse r x (c_i p).
//
// Ladd, J. Fluid Mech. 271 (1994) 285, eqs (3.2)-(3.3); Aidun, Lu & Ding, J. Fluid Mech. 373 (1998) 287.

namespace beadswim {

/// c.(v + omega x r)
BEADSWIM_KERNEL double speed_along(const double (&c)[3], const double (&v)[3], const double (&omega)[3],
                                   const double (&r)[3]) {
  return c[0] * (v[0] + (omega[1] * r[2] - omega[2] * r[1])) +
         c[1] * (v[1] + (omega[2] * r[0] - omega[0] * r[2])) +
         c[2] * (v[2] + (omega[0] * r[1] - omega[1] * r[0]));
}

/// What comes back when `outgoing` leaves along a direction of this weight; approach_speed = c_i.u_w.
BEADSWIM_KERNEL double bounced(double weight, double outgoing, double approach_speed) {
  return outgoing - 6 * weight * approach_speed;
}

/// Share of one link in the density around a covered cell: w_i r = f_i* - 3 w_i c_i.u_w to first order.
BEADSWIM_KERNEL double weighted_density_deviation(double weight, double outgoing, double approach_speed) {
  return outgoing - 3 * weight * approach_speed;
}

}  // namespace beadswim
