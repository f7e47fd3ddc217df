#pragma once

#include "beadswim/theory/collinear_swimmer.hpp"
#include "beadswim/theory/stroke.hpp"

// clang-format off
// Closed expressions for a swimmer of equal radii, equal arms and equal stiffnesses without dashpots, to second order in
// amplitude. Velocities are positive from bead 1 towards bead 3.
//
//   lambda, l       bead radius, rest length of the arms [length]
//   k               stiffness of the springs [mass/time^2]
//   A, B, alpha     driving amplitudes [mass length/time^2] and driving phase [rad] of (2.1)
//   omega           angular frequency of the driving [rad/time]
//   d1, d2          arm amplitudes [length];  delta1, delta2  arm phases [rad]
//   S               = omega d1 d2 sin(delta1 - delta2) [length^2/time]
//   W               = pi eta omega lambda [mass/time^2];  eta  dynamic viscosity [mass/(length time)]
//   v_S, v_F        velocity from a given stroke, velocity from the driving forces [length/time]
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
//   sin(delta1 - delta2) = N/D, for the driven swimmer                                                         (4.6) to (4.8)
//
// With the stroke of (4.4) to (4.8), v_S = v_F identically.
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
//             which is (4.2), divided by the velocity of the same stroke without truncation in lambda/l.
//
// Unweighted mean of the bead velocities, without the mean change of the arms and without truncation in lambda/l:
//
//            2ap - bq - 2p + q
//   v  =  ------------------------ S,     a = gamma mu_12, b = gamma mu_13, p = da/dr, q = db/dr, gamma = 6 pi eta lambda
//         3 (b - 1) (4a - b - 3)
// clang-format on
//
// Reference: Pickl, Pande, Koestler, Ruede and Smith, J. Phys.: Condens. Matter 29, 124001 (2017).
// Page: docs/method/closed-forms.md.

namespace beadswim {

/// Returns v_S of (4.2) [length/time]. Requires equal radii and equal arms.
double oseen_stroke_velocity(const CollinearSwimmer& swimmer, const Stroke& stroke);

/// Returns v_F of (4.3) [length/time].
double oseen_force_velocity(const CollinearSwimmer& swimmer);

/// Returns v_F of (4.23) as printed [length/time]. The printed formula depends on neither B nor alpha.
double rpy_force_velocity_printed(const CollinearSwimmer& swimmer);

/// Returns v_F of (4.23) with the printing errors corrected, for any A, B and alpha [length/time].
double rpy_force_velocity_repaired(const CollinearSwimmer& swimmer);

/// Returns v_S of (4.24) [length/time]. Requires equal radii and equal arms.
double rpy_stroke_velocity(const CollinearSwimmer& swimmer, const Stroke& stroke);

/// Returns the ratio v_S / v_F of (4.9) as printed.
double oseen_ratio_printed(const CollinearSwimmer& swimmer);

/// Returns the corrected ratio (4.9): velocity to lowest order in lambda/l, divided by the velocity of the
/// same stroke without truncation.
double oseen_ratio_repaired(const CollinearSwimmer& swimmer);

/// Returns the unweighted mean of the bead velocities with Rotne-Prager mobilities [length/time]. Requires
/// equal radii and equal arms.
double equal_weight_velocity(const CollinearSwimmer& swimmer, const Stroke& stroke);

/// Returns the arm amplitudes d1, d2 of (4.4) and (4.5) [length].
std::array<double, 2> oseen_arm_amplitudes(const CollinearSwimmer& swimmer);

/// Returns sin(delta1 - delta2) of (4.6) to (4.8); 0 if an arm is at rest.
double oseen_sin_phase_shift(const CollinearSwimmer& swimmer);

}  // namespace beadswim
