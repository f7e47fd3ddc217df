#pragma once

#include "beadswim/core/kernel.hpp"
#include "beadswim/lattice/trt.hpp"

// Reflection of a population at the surface of a moving bead, and the impulse on the bead, for one link, by
// the three schemes that have links (BeadScheme).
//
// clang-format off
//   staircase  f_ibar(x, n+1) = f_i*(x) - 6 w_i c_i.u_w
//   cli        f_ibar(x, n+1) = f_i*(x) + k (f_i*(x - c_i) - f_ibar*(x)) - 6 w_i (1 + k) c_i.u_w
//   mr         f_ibar(x, n+1) = f_i*(x) + k1 (f_i*(x -   c_i) - f_ibar*(x))
//                                       + k2 (f_i*(x - 2 c_i) - f_ibar*(x - c_i))
//                                       + a (L g_i - 3 w_i c_i.u_w)
//   impulse    c_i (f_i*(x) + f_ibar(x, n+1))
//
//   k  = (1 - 2 q)/(1 + 2 q)
//   k1 = (1 - 2 q - 2 q^2)/(1 + q)^2,   k2 = q^2/(1 + q)^2,   a = 4/(1 + q)^2
//   g_i = (m_i - 3 w_i c_i.u)/(1 - t),  m_i = (f_i* - f_ibar*)/2 at x,  u = sum c_i f_i* at x
// clang-format on
//
//   n           number of the time step; all populations on the right-hand side are those of step n
//   f_i, f_i*   population before and after the collision, minus w_i;  ibar opposite to i
//   i           points from the fluid cell x into the bead;  w_i, c_i weight and velocity (d3q19.hpp)
//   q           fraction of the link between x and the surface of the bead, 0 <= q <= 1
//   u_w         velocity of the bead at its surface [cell/step]; staircase: half-way along the link
//   t           = 1/w-, the antisymmetric relaxation time [step];  L = t - 1/2 (trt.hpp)
//
// Lattice units, mean density 1. Because w_i is subtracted, the pressure of the fluid at rest is left out.
// The force of this pressure on a closed surface is zero.
//
// Let r be the vector from the centre of the bead to the covered cell at the end of the link. Then u_w = v +
// omega x (r - s c_i) with a number s. The term s c_i contributes neither to c_i.u_w nor to the angular
// impulse r x (c_i p).
//
// staircase: half-way bounce-back, exact in a linear shear flow only for q = 1/2.
// Ladd, J. Fluid Mech. 271 (1994) 285, eqs (3.2)-(3.3); Aidun, Lu & Ding, J. Fluid Mech. 373 (1998) 287.
//
// cli: central linear interpolation, exact in a linear shear flow for any q and any viscosity. The velocity
// field of a steady slow flow does not depend on the viscosity, because trt.hpp keeps the product
// (1/w+ - 1/2)(1/w- - 1/2) of the relaxation rates fixed.
// Ginzburg, Verhaeghe & d'Humieres, Commun. Comput. Phys. 3 (2008) 427, section 5.
//
// mr: multireflection (MR1), exact for steady flows with parabolic velocity and linear pressure along the
// link, for any q and viscosity. g_i is the change of the antisymmetric part of the populations in a
// collision. Interpolation alone would leave a slip velocity at the wall; the term L g_i removes it. At t = 1
// the populations after the collision do not contain g_i, and the scheme is undefined.
//
// Ginzburg & d'Humieres, Phys. Rev. E 68 (2003) 066614, MR1; section 5 of the paper of 2008.

namespace beadswim {

/// Returns c.(v + omega x r), the velocity along direction c of a bead with velocity v and angular velocity
/// omega, at the point r relative to its centre.
BEADSWIM_KERNEL double speed_along(const double (&c)[3], const double (&v)[3], const double (&omega)[3],
                                   const double (&r)[3]) {
  return c[0] * (v[0] + (omega[1] * r[2] - omega[2] * r[1])) +
         c[1] * (v[1] + (omega[2] * r[0] - omega[0] * r[2])) +
         c[2] * (v[2] + (omega[0] * r[1] - omega[1] * r[0]));
}

// In the following functions, weight is w_i, outgoing f_i*(x), and approach_speed c_i.u_w, the velocity of
// the bead along c_i.

/// Returns the population that `staircase` reflects.
BEADSWIM_KERNEL double bounced(double weight, double outgoing, double approach_speed) {
  return outgoing - 6 * weight * approach_speed;
}

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

/// Returns the interpolation weight k of a link.
BEADSWIM_KERNEL double interpolation_weight(double q) {
  return (1 - 2 * q) / (1 + 2 * q);
}

/// Returns the population that `cli` reflects. behind: f_i*(x - c_i); arrived: f_ibar*(x).
BEADSWIM_KERNEL double bounced_interpolated(double weight, double k, double outgoing, double behind,
                                            double arrived, double approach_speed) {
  // clang-format off
  return outgoing
       + k * (behind - arrived)
       - 6 * weight * (1 + k) * approach_speed;
  // clang-format on
}

/// Values that a multireflection link reads.
struct MultireflectionLink {
  double outgoing;        ///< f_i*(x)
  double arrived;         ///< f_ibar*(x)
  double behind;          ///< f_i*(x - c_i)
  double arrived_behind;  ///< f_ibar*(x - c_i)
  double two_behind;      ///< f_i*(x - 2 c_i)
  double speed;           ///< c_i.u(x)
};

/// Returns L/(1 - t), the factor of m_i - 3 w_i c_i.u in the slip correction L g_i. It is undefined at t = 1.
constexpr double multireflection_slip(const RelaxationRates& rates) {
  const double t = 1 / rates.antisymmetric;
  return (t - 0.5) / (1 - t);
}

/// Returns the population that `mr` reflects. slip: L/(1 - t).
BEADSWIM_KERNEL double bounced_multireflection(double weight, double q, double slip,
                                               const MultireflectionLink& f, double approach_speed) {
  // clang-format off
  const double over = 1 / ((1 + q) * (1 + q));
  const double k1   = (1 - 2 * q - 2 * q * q) * over;
  const double k2   = q * q * over;
  const double a    = 4 * over;
  return f.outgoing
       + k1 * (f.behind     - f.arrived)
       + k2 * (f.two_behind - f.arrived_behind)
       + a  * (slip * (0.5 * (f.outgoing - f.arrived) - 3 * weight * f.speed) - 3 * weight * approach_speed);
  // clang-format on
}

}  // namespace beadswim
