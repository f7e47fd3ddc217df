#pragma once

#include "beadswim/coupling/scene.hpp"

namespace beadswim {

/// Estimated error by roundoff of the swimmers' velocity in a run of `steps`, relative to the velocity, for
/// the type that fares worst. The velocity is that to second order in the driving. Single precision: from a
/// measured error relative to the speed of the fastest bead (docs/method/single-precision.md), infinite for a
/// type that is driven but does not swim. Double: from that of the way in a period, for types that swim.
double velocity_roundoff(const CoupledScene& scene, long steps_per_period, long steps);

/// Above this a run warns.
constexpr double tolerated_roundoff = 0.002;

}  // namespace beadswim
