#pragma once

#include "beadswim/theory/collinear_swimmer.hpp"
#include "beadswim/theory/stroke.hpp"

// clang-format off
// Closed expressions for a swimmer of equal radii, equal arms and equal stiffnesses without dashpots, to second order in
// amplitude. Velocities are positive from bead 1 towards bead 3. Numbers such as (4.2) are equations of the paper,
// which is cited below.
//
//   lambda, l       bead radius, rest length of the arms [length]
//   k               stiffness of the springs [mass/time^2]
//   A, B, alpha     driving amplitudes [mass length/time^2] and driving phase [rad] in equation (2.1)
//   omega           angular frequency of the driving [rad/time]
//   d1, d2          arm amplitudes [length];  delta1, delta2  arm phases [rad]
//   S               = omega d1 d2 sin(delta1 - delta2) [length^2/time]
//   W               = pi eta omega lambda [mass/time^2];  eta  dynamic viscosity [mass/(length time)]
//   v_S, v_F        velocity from a given stroke, velocity from the driving forces [length/time]
//   printed         formula as in the paper;  repaired  formula with the printing errors corrected
//
// Lowest order in lambda/l (Oseen):
//
//           7 lambda
//   v_S  =  -------- S                                                                                                  (4.2)
//            24 l^2
//
//           7 lambda omega [ AB (k^2 + 12 W^2) sin alpha + 2 (A^2 - B^2) W k ]
//   v_F  =  ------------------------------------------------------------------                                          (4.3)
//                     24 l^2 (k^2 + 4 W^2) (k^2 + 36 W^2)
//
//   d1^2 (k^2 + 4 W^2) (k^2 + 36 W^2)  =  A^2 k^2 + 4 W^2 (4 A^2 +   B^2 + 4 AB cos alpha) - 4 AB W k sin alpha         (4.4)
//   d2^2 (k^2 + 4 W^2) (k^2 + 36 W^2)  =  B^2 k^2 + 4 W^2 (  A^2 + 4 B^2 + 4 AB cos alpha) + 4 AB W k sin alpha         (4.5)
//   sin(delta1 - delta2) = N/D for the driven swimmer                                                          (4.6) to (4.8)
//
// For the stroke of equations (4.4) to (4.8), v_S and v_F are identical.
//
// Next order in lambda/l (Rotne-Prager):
//
//                     A^2 omega lambda (28l - 45 lambda) [ (2l - 5 lambda) k^2 + 24 W^2 l ]
//   printed   v_F  =  ----------------------------------------------------------------------------,   A = B            (4.23)
//                     192 l^3 [ (l - 5 lambda) k^4 + 4 W^2 (8l - 33 lambda) k^2 + 144 W^4 l ]
//
//   repaired  in the numerator,   A^2 [ .. ] is replaced by
//                                 AB sin alpha [ (2l - 5 lambda) k^2 + 24 W^2 l ] + (A^2 - B^2) W k (4l - 9 lambda);
//             in the denominator, 8l - 33 lambda is replaced by 10l - 33 lambda
//
//           (28l - 99 lambda) lambda
//   v_S  =  ------------------------- S                                                                                (4.24)
//           24 l^2 (4l - 17 lambda)
//
// Ratio v_S / v_F (Oseen):
//
//   printed   7 (4l - 3 lambda) (4l - 7 lambda)   / { 4l (28l - 45 lambda) }                                            (4.9)
//   repaired  7 (4l - 7 lambda)^2 (4l - 3 lambda) / { 8l (56 l^2 - 198 l lambda + 189 lambda^2) },
//             which is v_S of equation (4.2), divided by the velocity of the same stroke with Oseen mobilities,
//             without truncation in lambda/l.
//
// Unweighted mean of the three bead velocities with Rotne-Prager mobilities, without truncation in lambda/l.
// It neglects the mean change of the arm lengths.
//
//            2ap - bq - 2p + q
//   v  =  ------------------------ S,     a = gamma mu_12, b = gamma mu_13, p = da/dr, q = db/dr, gamma = 6 pi eta lambda
//         3 (b - 1) (4a - b - 3)
//
//   mu_12, mu_13    mobilities of two beads at the distances r = l and r = 2l [time/mass]
// clang-format on
//
// The paper: Pickl, Pande, Koestler, Ruede and Smith, J. Phys.: Condens. Matter 29, 124001 (2017).
// Page: docs/method/closed-forms.md.

// Velocities [length/time] by a given stroke and the ratios require equal radii and equal arms; formulas in
// terms of the driving also require equal stiffnesses and no dashpots.

namespace beadswim {

/// Return v_S of a given stroke by equations (4.2) and (4.24), and v of the unweighted mean (last formula).
double oseen_stroke_velocity(const CollinearSwimmer& swimmer, const Stroke& stroke);
double rpy_stroke_velocity(const CollinearSwimmer& swimmer, const Stroke& stroke);
double equal_weight_velocity(const CollinearSwimmer& swimmer, const Stroke& stroke);

/// Return v_F by equations (4.3) and (4.23). Equation (4.23) as printed depends on neither B nor alpha.
double oseen_force_velocity(const CollinearSwimmer& swimmer);
double rpy_force_velocity_printed(const CollinearSwimmer& swimmer);
double rpy_force_velocity_repaired(const CollinearSwimmer& swimmer);

/// Return the ratio v_S/v_F of equation (4.9).
double oseen_ratio_printed(const CollinearSwimmer& swimmer);
double oseen_ratio_repaired(const CollinearSwimmer& swimmer);

/// Returns the arm amplitudes d1, d2 by equations (4.4) and (4.5) [length].
std::array<double, 2> oseen_arm_amplitudes(const CollinearSwimmer& swimmer);

/// Returns sin(delta1 - delta2) by equations (4.6) to (4.8), or 0 if an arm is at rest.
double oseen_sin_phase_shift(const CollinearSwimmer& swimmer);

}  // namespace beadswim
