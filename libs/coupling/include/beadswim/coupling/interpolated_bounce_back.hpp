#pragma once

#include "beadswim/core/kernel.hpp"

// Bounce-back at a moving wall at its position on the link, by central linear interpolation (CLI).
//
//   f_ibar(x, t+1) = f_i*(x) + k (f_i*(x - c_i) - f_ibar*(x)) - 6 w_i (1 + k) c_i.u_w
//   k              = (1 - 2 q) / (1 + 2 q)
//
//   f_i, f_i*   population before and after the collision, less w_i;  ibar opposite to i
//   i           points from the fluid cell x into the bead;  w_i, c_i weight and velocity (d3q19.hpp)
//   q           fraction of the link between x and the surface of the bead, 0 <= q <= 1
//   u_w         velocity of the bead at its surface [cell/step]
//
// Exact in a linear shear flow for any q and any viscosity, as bounce-back (k = 0) is for q = 1/2. Steady
// flows do not depend on the viscosity if the product of the two relaxation times is fixed (trt.hpp).
//
// Ginzburg, Verhaeghe & d'Humieres, Commun. Comput. Phys. 3 (2008) 427, section 5.

namespace beadswim {

/// Returns q for a sphere about the origin: the smaller root of (r - c + q c)^2 = R^2. c points from the
/// fluid cell into the sphere; r is the centre of the covered cell at the end of the link. The result is
/// limited to [0, 1].
BEADSWIM_KERNEL double wall_distance(const double (&c)[3], const double (&r)[3], double radius_squared) {
  const double cc = c[0] * c[0] + c[1] * c[1] + c[2] * c[2];
  const double rc = r[0] * c[0] + r[1] * c[1] + r[2] * c[2];
  const double rr = r[0] * r[0] + r[1] * r[1] + r[2] * r[2];
  // q^2 c.c + 2 q (r.c - c.c) + (r - c)^2 - R^2 = 0
  const double discriminant = rc * rc - cc * (rr - radius_squared);
  const double q = (cc - rc - __builtin_sqrt(discriminant > 0 ? discriminant : 0)) / cc;
  return q > 0 ? (q < 1 ? q : 1) : 0;
}

/// Returns k.
BEADSWIM_KERNEL double interpolation_weight(double q) {
  return (1 - 2 * q) / (1 + 2 * q);
}

/// Returns f_ibar(x, t+1) for outgoing = f_i*(x) along a direction of this weight; behind = f_i*(x - c_i),
/// arrived = f_ibar*(x), approach_speed = c_i.u_w.
BEADSWIM_KERNEL double bounced_interpolated(double weight, double k, double outgoing, double behind,
                                            double arrived, double approach_speed) {
  // clang-format off
  return outgoing
       + k * (behind - arrived)
       - 6 * weight * (1 + k) * approach_speed;
  // clang-format on
}

}  // namespace beadswim
