#pragma once

#include <string>
#include <vector>

#include "beadswim/scene/layout.hpp"

namespace beadswim {

/// An error in a layout.
struct LayoutFault {
  std::string place;    ///< JSON pointer to the place in layout.json, for example "/swimmers/3/position"
  std::string message;  ///< value found, values allowed, remedy
};

/// Returns the errors that a JSON schema cannot detect: units that contradict their names, arms shorter than
/// the sum of the radii of their beads, unknown types, repeated ids, axes that are not unit vectors, swimmers
/// outside the box, beads that cut walls, and beads that overlap (periodic images included). Returns an empty
/// list for a valid layout. Walls and overlaps of beads are checked only if all other checks pass. For each
/// swimmer the first error of its beads is returned.
std::vector<LayoutFault> check_layout(const Layout& layout);

/// Normalises the axes whose length differs from 1 by at most 1e-6. Leaves all other axes unchanged.
void normalise_axes(Layout& layout);

}  // namespace beadswim
