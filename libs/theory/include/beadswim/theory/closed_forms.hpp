#pragma once

#include "beadswim/theory/collinear_swimmer.hpp"
#include "beadswim/theory/stroke.hpp"

// Closed expressions for a swimmer of equal radii lambda, equal arms l and equal stiffnesses k without
// dashpots, to second order in amplitude and lowest order in lambda/l (Oseen). With W = pi eta omega lambda:
//
//   v_S = G d1 d2 omega sin(delta1 - delta2),   G = 7 lambda / (24 l^2)                              (4.2)
//   v_F = 7 lambda omega [AB (k^2 + 12 W^2) sin alpha + 2 (A^2 - B^2) W k]
//         / {24 l^2 (k^2 + 4 W^2) (k^2 + 36 W^2)}                                                    (4.3)
//   d1, d2 and sin(delta1 - delta2) of the driven swimmer                                  (4.4) to (4.8)
//
// With (4.4) to (4.8), v_S = v_F identically. Velocities count from bead 1 to bead 3.
//
// Reference: Pickl, Pande, Koestler, Ruede and Smith, J. Phys.: Condens. Matter 29, 124001 (2017).
// Page: docs/method/closed-forms.md.

namespace beadswim {

/// (4.2): velocity of a stroke; needs equal radii and equal arms only [length/time].
double oseen_stroke_velocity(const CollinearSwimmer& swimmer, const Stroke& stroke);

/// (4.3): velocity of the driven swimmer [length/time].
double oseen_force_velocity(const CollinearSwimmer& swimmer);

/// (4.4) and (4.5): amplitudes d1, d2 of the driven arms [length].
std::array<double, 2> oseen_arm_amplitudes(const CollinearSwimmer& swimmer);

/// (4.6) to (4.8): sin(delta1 - delta2) of the driven arms; 0 if an arm is at rest.
double oseen_sin_phase_shift(const CollinearSwimmer& swimmer);

}  // namespace beadswim
