#pragma once

#include <array>

#include "beadswim/swimmers/swimmer_type.hpp"
#include "beadswim/core/vec3.hpp"

// Forces inside one swimmer: springs and dashpots (2.2), angular spring, driving (2.1). All are pure
// functions of unwrapped bead positions. The sum of the forces on the three beads vanishes to roundoff. See
// docs/method/springs.md, driving.md.

namespace beadswim {

using BeadVectors = std::array<Vec3, 3>;

/// Returns the spring forces (2.2) with a dashpot parallel to each spring. Tension of each arm:
/// k (L - l) + c dL/dt.
BeadVectors spring_forces(const std::array<Spring, 2>& springs, const BeadVectors& position,
                          const BeadVectors& velocity);

/// Returns -grad U for U = K_A theta^2/2, where theta in [0, pi] is the angle between the directions of the
/// two arms.
BeadVectors angular_spring_forces(double angular_stiffness, const BeadVectors& position);

/// Returns the driving forces (2.1) at `time`. initial_axis: unit vector from bead 1 to bead 3 at the start
/// of the run.
BeadVectors driving_forces(const Driving& driving, double time, const BeadVectors& position,
                           const Vec3& initial_axis);

}  // namespace beadswim
