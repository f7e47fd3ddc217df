#pragma once

#include "beadswim/core/kernel.hpp"

// Half-way bounce-back at a moving wall, and the impulse on the bead, for one link.
//
//   f_ibar(x, t+1) = f_i*(x, t) - 6 w_i c_i.u_w          i points from the fluid cell x into the bead
//   impulse        = c_i (f_i*(x, t) + f_ibar(x, t+1))
//
// u_w: velocity of the bead half-way along the link. f: deviations from w_i. They leave out the pressure of
// the fluid at rest, whose sum over a closed surface is zero. Lattice units, mean density 1.
//
// Let r be the vector from the centre of the bead to the covered cell at the end of the link. Then u_w = v +
// omega x (r - c_i/2). The term c_i/2 contributes neither to c_i.u_w nor to the angular impulse r x (c_i p).
//
// Ladd, J. Fluid Mech. 271 (1994) 285, eqs (3.2)-(3.3); Aidun, Lu & Ding, J. Fluid Mech. 373 (1998) 287.

namespace beadswim {

/// Returns c.(v + omega x r).
BEADSWIM_KERNEL double speed_along(const double (&c)[3], const double (&v)[3], const double (&omega)[3],
                                   const double (&r)[3]) {
  return c[0] * (v[0] + (omega[1] * r[2] - omega[2] * r[1])) +
         c[1] * (v[1] + (omega[2] * r[0] - omega[0] * r[2])) +
         c[2] * (v[2] + (omega[0] * r[1] - omega[1] * r[0]));
}

/// Returns f_ibar(x, t+1) for outgoing = f_i*(x, t) along a direction of this weight; approach_speed =
/// c_i.u_w.
BEADSWIM_KERNEL double bounced(double weight, double outgoing, double approach_speed) {
  return outgoing - 6 * weight * approach_speed;
}

/// Returns the contribution of one link to the density deviation r around a covered cell:
/// w_i r = f_i* - 3 w_i c_i.u_w to first order.
BEADSWIM_KERNEL double weighted_density_deviation(double weight, double outgoing, double approach_speed) {
  return outgoing - 3 * weight * approach_speed;
}

}  // namespace beadswim
