#pragma once

#include "beadswim/core/kernel.hpp"
#include "beadswim/lattice/trt.hpp"

// Bounce-back at a moving wall, with the wall at its exact position on the link, by multireflection (MR1).
//
// clang-format off
//   f_ibar(x, n+1) = f_i*(x) + k1 (f_i*(x -   c_i) - f_ibar*(x))
//                            + k2 (f_i*(x - 2 c_i) - f_ibar*(x - c_i))
//                            + a (L g_i - 3 w_i c_i.u_w)
//
//   k1 = (1 - 2 q - 2 q^2)/(1 + q)^2,   k2 = q^2/(1 + q)^2,   a = 4/(1 + q)^2
//   g_i = (m_i - 3 w_i c_i.u)/(1 - t),  m_i = (f_i* - f_ibar*)/2 at x,  u = sum c_i f_i* at x
//
//   n           number of the time step; all populations on the right-hand side are those of step n
//   f_i, f_i*   population before and after the collision, minus w_i;  ibar opposite to i
//   i           points from the fluid cell x into the bead;  w_i, c_i weight and velocity (d3q19.hpp)
//   q           fraction of the link between x and the surface of the bead, 0 <= q <= 1
//   u_w         velocity of the bead at its surface [cell/step]
//   t           = 1/w-, the antisymmetric relaxation time [step];  L = t - 1/2 (trt.hpp)
//
// The scheme is exact for steady flows with parabolic velocity and linear pressure along the link, for any q
// and viscosity. g_i is the change of the antisymmetric part of the populations in a collision. Interpolation
// alone would leave a slip velocity at the wall; the term L g_i removes it. At t = 1 the populations after
// the collision do not contain g_i, and the scheme is undefined.
// clang-format on
//
// Ginzburg & d'Humieres, Phys. Rev. E 68 (2003) 066614, MR1; Ginzburg, Verhaeghe & d'Humieres, Commun.
// Comput. Phys. 3 (2008) 427, section 5.

namespace beadswim {

/// Values that a multireflection link reads. x: fluid cell; i: direction from x into the bead; ibar: opposite
/// direction; f*: populations after the collision; u: momentum.
struct MultireflectionLink {
  double outgoing;        ///< f_i*(x)
  double arrived;         ///< f_ibar*(x)
  double behind;          ///< f_i*(x - c_i)
  double arrived_behind;  ///< f_ibar*(x - c_i)
  double two_behind;      ///< f_i*(x - 2 c_i)
  double speed;           ///< c_i.u(x)
};

/// Returns L/(1 - t), the factor of m_i - 3 w_i c_i.u in the slip correction L g_i (see above). t is the
/// antisymmetric relaxation time, L = t - 1/2. The factor is undefined at t = 1.
constexpr double multireflection_slip(const RelaxationRates& rates) {
  const double t = 1 / rates.antisymmetric;
  return (t - 0.5) / (1 - t);
}

/// Returns the reflected population f_ibar(x, n+1) of the equation above. weight: w_i; q: fraction of the
/// link between fluid cell and surface; slip: L/(1 - t); approach_speed: c_i.u_w, the velocity of the bead
/// along c_i.
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
