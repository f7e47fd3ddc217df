#pragma once

#include "beadswim/coupling/scene.hpp"

namespace beadswim {

/// Returns the estimated relative error of the velocity of swimmers by roundoff, in a run of `steps` time
/// steps: the largest error of all swimmer types. The velocity of a swimmer is evaluated to second order in
/// the driving amplitude.
///
/// Single precision: the estimate is a measured error relative to the speed of the fastest bead
/// (docs/method/single-precision.md). The estimate is infinite for a type that is driven but does not swim.
///
/// Double precision: the estimate is the roundoff of the displacement in one period. Types that do not swim
/// are ignored.
double velocity_roundoff(const CoupledScene& scene, long steps_per_period, long steps);

}  // namespace beadswim
