#pragma once

#include <array>

#include "beadswim/swimmers/swimmer_type.hpp"
#include "beadswim/core/vec3.hpp"

// Forces inside one swimmer: springs and dashpots (2.2), angular spring, driving (2.1). Pure functions of
// unwrapped bead positions; sums over the three beads vanish to roundoff. See docs/method/springs.md,
// driving.md.

namespace beadswim {

using BeadVectors = std::array<Vec3, 3>;

/// (2.2) with a dashpot beside each spring: the tension k (L - l) + c dL/dt along each arm.
BeadVectors spring_forces(const std::array<Spring, 2>& springs, const BeadVectors& position,
                          const BeadVectors& velocity);

/// -grad of U = K_A theta^2 / 2, theta in [0, pi] the angle between the two arms' directions.
BeadVectors angular_spring_forces(double angular_stiffness, const BeadVectors& position);

/// (2.1) at `time`; `initial_axis` is the swimmer's unit vector from bead 1 to bead 3 at the start.
BeadVectors driving_forces(const Driving& driving, double time, const BeadVectors& position,
                           const Vec3& initial_axis);

}  // namespace beadswim
