#pragma once

#include "beadswim/core/vec3.hpp"
#include "beadswim/scene/layout.hpp"

namespace beadswim {

/// The smallest cell that a periodic scene is made of.
struct ReducedCell {
  Layout layout;             ///< one cell; of swimmers that are alike, the one that came first
  Index3 cells{1, 1, 1};     ///< how often it stands in the scene along x, y, z
  double largest_shift = 0;  ///< by which a swimmer is off its place in the repeated cell [length]
};

/// Finds the shortest box, edges parallel to the scene's, that repeats to the same scene along its periodic
/// axes: swimmers of equal type, driving and axis (to 1e-9) at places equal within `tolerance` [length]. Such
/// a scene stays periodic as it moves, so that one cell does for all. Walls are not repeated. Throws
/// InputError if the fluid is unbounded.
ReducedCell reduce(const Layout& layout, double tolerance);

}  // namespace beadswim
