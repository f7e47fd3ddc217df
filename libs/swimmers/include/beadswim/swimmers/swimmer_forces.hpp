#pragma once

#include <array>

#include "beadswim/swimmers/swimmer_type.hpp"
#include "beadswim/core/vec3.hpp"

// Forces inside one swimmer: springs and dashpots, equation (2.2) of the paper (Pickl et al. 2017), angular
// spring, and driving, equation (2.1). All functions are pure. Bead positions are unwrapped. The sum of the
// forces on the three beads vanishes to roundoff. See docs/method/springs.md and driving.md.

namespace beadswim {

using BeadVectors = std::array<Vec3, 3>;

/// Returns the forces of the springs and of the dashpots parallel to them on beads 1, 2, 3, equation (2.2) of
/// the paper. The tension of an arm of length L is k (L - l) + c dL/dt, with stiffness k, rest length l and
/// damping c.
BeadVectors spring_forces(const std::array<Spring, 2>& springs, const BeadVectors& position,
                          const BeadVectors& velocity);

/// Returns the forces -grad U on beads 1, 2, 3 for the bending energy U = K_A theta^2/2. K_A is the angular
/// stiffness. theta in [0, pi] is the angle between the directions of the two arms.
BeadVectors angular_spring_forces(double angular_stiffness, const BeadVectors& position);

/// Returns the driving forces on beads 1, 2, 3 at `time`, equation (2.1) of the paper. initial_axis: unit
/// vector from bead 1 to bead 3 at the start of the run.
BeadVectors driving_forces(const Driving& driving, double time, const BeadVectors& position,
                           const Vec3& initial_axis);

}  // namespace beadswim
