#pragma once

#include <string>
#include <vector>

#include "beadswim/scene/layout.hpp"
#include "beadswim/theory/question.hpp"

namespace beadswim {

/// A swimmer that represents all swimmers of the same type and driving, with its question to theory.
struct Representative {
  int swimmer = 0;   ///< id of the swimmer
  SwimmerType type;  ///< its type, with its own driving
  Question question;
  /// Text on the approximation of neighbours, box or driving in `question`; empty if there is none.
  std::string approximation;
  bool is_slanted = false;  ///< whether driving forces act perpendicular to its axis too
};

/// Returns one representative for each type and driving; drivings that differ only in phase offset count as
/// one. For a type with more than eight drivings, it returns up to five: the first one, and those with the
/// largest and smallest force and the longest and shortest period. `cell`: the smallest cell that the scene
/// repeats (scene/reduce.hpp). Throws InputError for swimmers without springs.
std::vector<Representative> representatives(const Layout& cell);

}  // namespace beadswim
