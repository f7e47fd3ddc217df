#pragma once

#include "scene_on_lattice.hpp"

namespace beadswim {

/// Estimated error of the swimmers' velocity from populations in single precision, relative to the velocity,
/// for the type that fares worst; infinite for one that is driven but does not swim. From a measured error
/// relative to the speed of the fastest bead (docs/method/single-precision.md) and the velocity to second
/// order in the driving.
double single_precision_error(const CoupledScene& scene, long steps);

/// Above this a run warns.
constexpr double tolerated_precision_error = 0.002;

}  // namespace beadswim
