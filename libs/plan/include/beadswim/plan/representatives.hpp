#pragma once

#include <string>
#include <vector>

#include "beadswim/scene/layout.hpp"
#include "beadswim/theory/question.hpp"

namespace beadswim {

/// A swimmer that stands for those like it, as theory is asked about it.
struct Representative {
  int swimmer = 0;   ///< its id
  SwimmerType type;  ///< with its own driving
  Question question;
  /// What theory cannot know of it, and what stands in its place; empty if nothing.
  std::string approximation;
  bool is_slanted = false;  ///< driven across its line too
};

/// One for each type and driving (whatever its phase offset); of more than eight drivings of a type the
/// first, those of the largest and smallest force and of the longest and shortest period. `cell`: a scene's
/// smallest cell. Throws InputError where a swimmer is none to theory, without springs for one.
std::vector<Representative> representatives(const Layout& cell);

}  // namespace beadswim
