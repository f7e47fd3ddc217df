#pragma once

#include <string>
#include <vector>

#include "beadswim/scene/layout.hpp"
#include "beadswim/swimmers/three_bead_swimmer.hpp"
#include "beadswim/theory/question.hpp"

namespace beadswim {

/// A swimmer that represents all swimmers of the same type and driving, and the input of theory for it.
struct Representative {
  int swimmer = 0;        ///< id of the swimmer
  ThreeBeadSwimmer type;  ///< type of the swimmer, with the driving of the swimmer, or its stand-in
  Question question;
  /// States how `question` approximates the neighbours, the box or the driving; empty if it does not.
  std::string approximation;
  /// True: the swimmer is not the paper's, and `question` is for three beads with similar radii, distances
  /// and strokes. Their errors have not been validated for the shape.
  bool is_stand_in = false;
  bool is_slanted = false;  ///< true: driving forces have a component normal to the axis
};

/// Returns one representative for each type and each driving of this type. Drivings that differ only in phase
/// offset count as one. For a type with more than eight drivings, the result contains at most five swimmers
/// of this type: the first swimmer, the swimmers with the largest and the smallest force, and the swimmers
/// with the longest and the shortest period. `cell`: smallest cell whose repetition gives the scene
/// (scene/reduce.hpp). Throws InputError for swimmers without springs.
std::vector<Representative> representatives(const Layout& cell);

}  // namespace beadswim
