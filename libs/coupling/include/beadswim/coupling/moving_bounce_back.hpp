#pragma once

#include "beadswim/core/kernel.hpp"

// Half-way bounce-back at a moving wall, and the impulse on the bead, for one link.
//
//   f_ibar(x, t+1) = f_i*(x, t) - 6 w_i c_i.u_w          i points from the fluid cell x into the bead
//   impulse        = c_i (f_i*(x, t) + f_ibar(x, t+1))
//
// t: number of the time step; u_w: velocity of the bead half-way along the link; f_i, f_i*: population before
// and after the collision, minus w_i; w_i, c_i: weight and velocity of direction i; ibar: direction opposite
// to i. Lattice units, mean density 1. Because w_i is subtracted, the pressure of the fluid at rest is left
// out. The force of this pressure on a closed surface is zero.
//
// Let r be the vector from the centre of the bead to the covered cell at the end of the link. Then u_w = v +
// omega x (r - c_i/2). The term c_i/2 contributes neither to c_i.u_w nor to the angular impulse r x (c_i p).
//
// Ladd, J. Fluid Mech. 271 (1994) 285, eqs (3.2)-(3.3); Aidun, Lu & Ding, J. Fluid Mech. 373 (1998) 287.

namespace beadswim {

/// Returns c.(v + omega x r), the velocity along direction c of a bead with velocity v and angular velocity
/// omega, at the point r relative to its centre.
BEADSWIM_KERNEL double speed_along(const double (&c)[3], const double (&v)[3], const double (&omega)[3],
                                   const double (&r)[3]) {
  return c[0] * (v[0] + (omega[1] * r[2] - omega[2] * r[1])) +
         c[1] * (v[1] + (omega[2] * r[0] - omega[0] * r[2])) +
         c[2] * (v[2] + (omega[0] * r[1] - omega[1] * r[0]));
}

/// Returns the reflected population f_ibar(x, t+1) of the equation above. weight: w_i; outgoing: f_i*(x, t);
/// approach_speed: c_i.u_w, the velocity of the bead along c_i.
BEADSWIM_KERNEL double bounced(double weight, double outgoing, double approach_speed) {
  return outgoing - 6 * weight * approach_speed;
}

/// Returns w_i r = f_i* - 3 w_i c_i.u_w, an estimate of the density deviation r of the fluid next to a
/// covered cell, multiplied by the weight w_i of the link. outgoing: population f_i* that leaves along the
/// link; approach_speed: c_i.u_w, the velocity of the bead along c_i. The estimate is of first order in the
/// velocity.
BEADSWIM_KERNEL double weighted_density_deviation(double weight, double outgoing, double approach_speed) {
  return outgoing - 3 * weight * approach_speed;
}

}  // namespace beadswim
