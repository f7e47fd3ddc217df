#pragma once

#include "beadswim/core/vec3.hpp"
#include "beadswim/scene/layout.hpp"

namespace beadswim {

/// The smallest box whose periodic repetition gives a scene.
struct ReducedCell {
  Layout layout;          ///< one cell; of equivalent swimmers it contains the first one
  Index3 cells{1, 1, 1};  ///< number of repetitions along x, y, z
  double largest_shift =
      0;  ///< largest distance of a swimmer from its position in the repeated cell [length]
};

/// Finds the smallest box, with edges parallel to the scene's box, that gives the scene when it is repeated
/// along the periodic axes. Two swimmers are equivalent if they have the same type and driving, the same axis
/// to 1e-9, and positions that agree within `tolerance` [length]. Such a scene stays periodic while it moves,
/// so a simulation of one cell suffices. Axes with walls are not divided. Throws InputError if the fluid is
/// unbounded or if the tolerance is so large that different swimmers are taken as equivalent.
ReducedCell reduce(const Layout& layout, double tolerance);

}  // namespace beadswim
