#pragma once

#include "beadswim/core/vec3.hpp"
#include "beadswim/scene/layout.hpp"

namespace beadswim {

/// The smallest box whose periodic repetition gives a scene.
struct ReducedCell {
  Layout layout;          ///< one cell, with the first swimmer of each equivalent group
  Index3 cells{1, 1, 1};  ///< number of repetitions along x, y, z
  double largest_shift =
      0;  ///< largest distance of a swimmer from its position in the repeated cell [length]
};

/// Finds the smallest box, with edges parallel to the scene's box, that gives the scene when it is repeated
/// along the periodic axes. Axes with walls are not divided. Each swimmer of this cell stands for a group of
/// equivalent swimmers. Equivalent swimmers have the same type, the same driving, axes that agree to 1e-9,
/// and positions that agree within `tolerance` [length] after a displacement by whole cells. During a run
/// such a scene keeps this periodicity, so that a simulation of one cell suffices. Throws InputError if the
/// fluid is unbounded or if the tolerance is so large that different swimmers are taken as equivalent.
ReducedCell reduce(const Layout& layout, double tolerance);

}  // namespace beadswim
