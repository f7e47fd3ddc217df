#pragma once

#include "beadswim/swimmers/swimmer_shape.hpp"

// Shapes of a swimmer on which its springs and angular springs, with their drives, are in equilibrium. Page:
// docs/method/springs.md.

namespace beadswim {

/// Returns true if drives change rest lengths or rest angles, and thereby prescribe a shape.
bool has_driven_shape(const Driving& driving);

struct RelaxedShape {
  BeadVectors beads;  ///< in the frame of the type, with mean position and orientation of those at rest
  bool is_converged = false;  ///< false: no equilibrium was found; `beads` have the smallest energy found
};

/// Returns the shape of smallest energy of springs and angular springs, with their drives at time 0, that is
/// reached from the beads at rest. Springs that fit together exert no forces on it. The beads move as little
/// as possible: deformations that no spring resists stay as they are, and each angle stays on its side.
RelaxedShape relaxed_shape(const SwimmerType& type);

/// Returns the type with its beads where they are at the start of a run: on the relaxed shape if the type has
/// a driven shape, otherwise at rest. A type whose beads are there within roundoff is returned unchanged.
SwimmerType at_start(SwimmerType type);

}  // namespace beadswim
