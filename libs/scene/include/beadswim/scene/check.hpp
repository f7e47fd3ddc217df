#pragma once

#include <string>
#include <vector>

#include "beadswim/scene/layout.hpp"

namespace beadswim {

/// One thing wrong with a layout.
struct LayoutFault {
  std::string place;    ///< where in layout.json, as a JSON pointer: "/swimmers/3/position"
  std::string message;  ///< the value, what is allowed, the remedy
};

/// What a schema cannot say: units that contradict their names, arms shorter than their beads, unknown types,
/// ids given twice, axes that are not unit vectors, swimmers outside the box, beads across walls, beads that
/// overlap (periodic images included). Empty if all is well. Beads are looked at only when the rest is sound,
/// and a swimmer's first fault is told for all of its beads.
std::vector<LayoutFault> check_layout(const Layout& layout);

/// Makes axes that are unit vectors to 1e-6 unit vectors to roundoff, and leaves others as they are.
void normalise_axes(Layout& layout);

}  // namespace beadswim
