#pragma once

#include <string>
#include <vector>

#include "beadswim/io/json.hpp"
#include "quantity.hpp"

// Studies: layouts that differ in the values of a few named quantities.

namespace beadswim {

/// A quantity and the values that it takes in turn.
struct Variation {
  std::string name;          ///< as quantity_name() returns it
  std::vector<Json> values;  ///< numbers (angles in radian) or words
};

/// Parses NAME=FROM:TO:COUNT, NAME=FROM:TO:COUNT:log or NAME=VALUE,VALUE,... Throws InputError with the
/// nearest name if NAME names no quantity.
Variation parse_variation(const std::string& text);

/// Returns the values of all layouts of a study with at least one variation: all combinations, the last
/// variation changing first, or with `together` the first values of all variations, the second values, and so
/// on. Throws InputError if a name occurs twice, or if the numbers of values differ although they change
/// together.
std::vector<StudyPoint> study_points(const std::vector<Variation>& variations, bool together);

}  // namespace beadswim
