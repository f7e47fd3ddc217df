#pragma once

#include <string>
#include <vector>

#include "beadswim/study/quantity.hpp"

// Studies: layouts that differ in the values of a few named quantities.

namespace beadswim {

/// A quantity and the values that it takes in turn.
struct Variation {
  std::string name;          ///< as quantity_name() returns it
  std::vector<Json> values;  ///< numbers (angles in radian) or words
};

/// Largest number of values of a quantity, and of layouts of a study.
constexpr std::size_t max_study_points = 1000000;

/// Returns the values of all layouts of a study with at least one variation: all combinations, the last
/// variation changing first, or with `together` the first values of all variations, which must have equally
/// many, the second values, and so on. Throws InputError if a name occurs twice or if there are too many
/// combinations. `flag`: flag of the command line that gave the variations, for messages.
std::vector<StudyPoint> study_points(const std::vector<Variation>& variations, bool together,
                                     const std::string& flag);

}  // namespace beadswim
