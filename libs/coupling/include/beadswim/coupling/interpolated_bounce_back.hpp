#pragma once

#include "beadswim/core/kernel.hpp"

// Bounce-back at a moving wall, with the wall at its exact position on the link, by central linear
// interpolation (CLI).
//
//   f_ibar(x, t+1) = f_i*(x) + k (f_i*(x - c_i) - f_ibar*(x)) - 6 w_i (1 + k) c_i.u_w
//   k              = (1 - 2 q) / (1 + 2 q)
//
//   t           number of the time step; all populations on the right-hand side are those of step t
//   f_i, f_i*   population before and after the collision, minus w_i;  ibar opposite to i
//   i           points from the fluid cell x into the bead;  w_i, c_i weight and velocity (d3q19.hpp)
//   q           fraction of the link between x and the surface of the bead, 0 <= q <= 1
//   u_w         velocity of the bead at its surface [cell/step]
//
// The scheme is exact in a linear shear flow for any q and any viscosity. Half-way bounce-back (k = 0) is
// exact only for q = 1/2. The velocity field of a steady slow flow does not depend on the viscosity, because
// trt.hpp keeps the product (1/w+ - 1/2)(1/w- - 1/2) of the relaxation rates fixed.
//
// Ginzburg, Verhaeghe & d'Humieres, Commun. Comput. Phys. 3 (2008) 427, section 5.

namespace beadswim {

/// Returns q, the fraction of the link between the fluid cell and the surface of a sphere of radius R about
/// the origin: the smaller root of (r - c + q c)^2 = R^2. c points from the fluid cell into the sphere; r is
/// the centre of the covered cell at the end of the link. The result is limited to [0, 1].
BEADSWIM_KERNEL double wall_distance(const double (&c)[3], const double (&r)[3], double radius_squared) {
  const double cc = c[0] * c[0] + c[1] * c[1] + c[2] * c[2];
  const double rc = r[0] * c[0] + r[1] * c[1] + r[2] * c[2];
  const double rr = r[0] * r[0] + r[1] * r[1] + r[2] * r[2];
  // q^2 c.c + 2 q (r.c - c.c) + (r - c)^2 - R^2 = 0
  const double discriminant = rc * rc - cc * (rr - radius_squared);
  const double q = (cc - rc - __builtin_sqrt(discriminant > 0 ? discriminant : 0)) / cc;
  return q > 0 ? (q < 1 ? q : 1) : 0;
}

/// Returns the interpolation weight k = (1 - 2 q)/(1 + 2 q) of a link. q: fraction of the link between the
/// fluid cell and the surface of the bead.
BEADSWIM_KERNEL double interpolation_weight(double q) {
  return (1 - 2 * q) / (1 + 2 * q);
}

/// Returns the reflected population f_ibar(x, t+1) of the equation above. weight: w_i; outgoing: f_i*(x);
/// behind: f_i*(x - c_i); arrived: f_ibar*(x); approach_speed: c_i.u_w, the velocity of the bead along c_i.
BEADSWIM_KERNEL double bounced_interpolated(double weight, double k, double outgoing, double behind,
                                            double arrived, double approach_speed) {
  // clang-format off
  return outgoing
       + k * (behind - arrived)
       - 6 * weight * (1 + k) * approach_speed;
  // clang-format on
}

}  // namespace beadswim
