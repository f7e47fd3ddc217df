#pragma once

#include <span>

#include "beadswim/compare/cycle_statistics.hpp"
#include "beadswim/core/vec3.hpp"
#include "beadswim/swimmers/three_bead_swimmer.hpp"

namespace beadswim {

/// Returns the mean power P of the driving forces in one cycle [mass length^2/time^3].
///
/// The sum of the forces is zero, so that P = <-F_1 dq_1/dt + F_3 dq_2/dt>. For forces along a fixed
/// direction e, q_1 = e (x_2 - x_1) and q_2 = e (x_3 - x_2); for forces along the arms, q_1 and q_2 are the
/// arm lengths. F_1 = A sin(w t + phi) and F_3 = B sin(w t + alpha + phi) are pure sines, so that only the
/// part d_i cos(w t + delta_i) of q_i contributes, at any amplitude:
///
///   P = w/2 [A d_1 cos(delta_1 - phi) - B d_2 cos(delta_2 - alpha - phi)]
///
///   samples       as for cycle_statistics()
///   initial_axis  axis of the swimmer at the start of the run; used for DrivingFrame::initial_axis
/// Throws InputError as fit_cycle() does.
double driving_power(const ThreeBeadDriving& driving, const Vec3& initial_axis,
                     std::span<const SwimmerSample> samples);

}  // namespace beadswim
