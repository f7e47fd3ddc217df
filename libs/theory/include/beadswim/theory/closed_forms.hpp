#pragma once

#include "beadswim/theory/collinear_swimmer.hpp"
#include "beadswim/theory/stroke.hpp"

// clang-format off
// Closed expressions for a swimmer of equal radii, equal arms and equal stiffnesses without dashpots, to second order in
// amplitude. Velocities count from bead 1 to bead 3.
//
//   lambda          radius of the beads, l rest length of the arms [length];  k stiffness of the springs [mass/time^2]
//   A, B, alpha     amplitudes [mass length/time^2] and phase of the driving (2.1);  omega its angular frequency [1/time]
//   d1, d2          amplitudes of the arms [length], delta1, delta2 their phases;  S = omega d1 d2 sin(delta1 - delta2)
//   W               = pi eta omega lambda [mass/time^2], eta the dynamic viscosity [mass/(length time)]
//   v_S, v_F        velocity of a stroke, and of the driven swimmer [length/time]
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
//   sin(delta1 - delta2) = N/D, of the driven swimmer                                                          (4.6) to (4.8)
//
// With (4.4) to (4.8), v_S = v_F identically.
//
// The next order in lambda/l, from Rotne-Prager pairs:
//
//                     A^2 omega lambda (28l - 45 lambda) [ (2l - 5 lambda) k^2 + 24 W^2 l ]
//   printed   v_F  =  ----------------------------------------------------------------------------,   A = B            (4.23)
//                     192 l^3 [ (l - 5 lambda) k^4 + 4 W^2 (8l - 33 lambda) k^2 + 144 W^4 l ]
//
//   repaired  A^2 [ .. ] above is AB sin alpha [ (2l - 5 lambda) k^2 + 24 W^2 l ] + (A^2 - B^2) W k (4l - 9 lambda),
//             and 8l - 33 lambda below is 10l - 33 lambda
//
//           (28l - 99 lambda) lambda
//   v_S  =  ------------------------- S                                                                                (4.24)
//           24 l^2 (4l - 17 lambda)
//
// and from Oseen pairs v_S over v_F,
//
//   printed   7 (4l - 3 lambda) (4l - 7 lambda)   / { 4l (28l - 45 lambda) }                                            (4.9)
//   right     7 (4l - 7 lambda)^2 (4l - 3 lambda) / { 8l (56 l^2 - 198 l lambda + 189 lambda^2) },
//             which is (4.2) over the velocity of the same stroke without truncation in lambda/l.
//
// Equal-weight mean of the beads' velocities without the mean change of the arms, untruncated:
//
//            2ap - bq - 2p + q
//   v  =  ------------------------ S,     a = gamma mu_12, b = gamma mu_13, p and q their slopes, gamma = 6 pi eta lambda
//         3 (b - 1) (4a - b - 3)
// clang-format on
//
// Reference: Pickl, Pande, Koestler, Ruede and Smith, J. Phys.: Condens. Matter 29, 124001 (2017).
// Page: docs/method/closed-forms.md.

namespace beadswim {

/// (4.2): velocity of a stroke; needs equal radii and equal arms only [length/time].
double oseen_stroke_velocity(const CollinearSwimmer& swimmer, const Stroke& stroke);

/// (4.3): velocity of the driven swimmer [length/time].
double oseen_force_velocity(const CollinearSwimmer& swimmer);

/// (4.23) as printed; uses A alone, and no alpha [length/time].
double rpy_force_velocity_printed(const CollinearSwimmer& swimmer);

/// (4.23) repaired, of any A, B and alpha [length/time].
double rpy_force_velocity_repaired(const CollinearSwimmer& swimmer);

/// (4.24): velocity of a stroke; needs equal radii and equal arms only [length/time].
double rpy_stroke_velocity(const CollinearSwimmer& swimmer, const Stroke& stroke);

/// (4.9) as printed: v_S over v_F.
double oseen_ratio_printed(const CollinearSwimmer& swimmer);

/// (4.9) as it should be: lowest-order over untruncated velocity of the same stroke.
double oseen_ratio_repaired(const CollinearSwimmer& swimmer);

/// Equal-weight mean of bead velocities by Rotne-Prager pairs; equal radii and equal arms [length/time].
double equal_weight_velocity(const CollinearSwimmer& swimmer, const Stroke& stroke);

/// (4.4) and (4.5): amplitudes d1, d2 of the driven arms [length].
std::array<double, 2> oseen_arm_amplitudes(const CollinearSwimmer& swimmer);

/// (4.6) to (4.8): sin(delta1 - delta2) of the driven arms; 0 if an arm is at rest.
double oseen_sin_phase_shift(const CollinearSwimmer& swimmer);

}  // namespace beadswim
