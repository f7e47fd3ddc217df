#pragma once

#include <string>
#include <utility>
#include <vector>

#include "beadswim/documents/layout_document.hpp"

// Studies: layouts that differ in the values of a few named quantities.

namespace beadswim {

/// A quantity and the values that it takes in turn.
struct Variation {
  std::string name;  ///< a flag of beadswim-layout swimmer without --, or a JSON pointer into the layout
  std::vector<Json> values;  ///< numbers (angles in radian) or words

  bool is_pointer() const { return name.starts_with('/'); }
};

/// Parses NAME=FROM:TO:COUNT, NAME=FROM:TO:COUNT:log or NAME=VALUE,VALUE,... Throws InputError with the
/// nearest name if NAME is neither a JSON pointer nor a flag of beadswim-layout swimmer.
Variation parse_variation(const std::string& text);

/// Values of the quantities of a study, by name.
using StudyPoint = std::vector<std::pair<std::string, Json>>;

/// Returns the values of all layouts of a study: all combinations, the last variation changing first, or with
/// `together` the first values of all variations, the second values, and so on. Throws InputError if a name
/// occurs twice, or if the numbers of values differ although they change together.
std::vector<StudyPoint> study_points(const std::vector<Variation>& variations, bool together);

/// Returns the layout with the values of `point`. `layout`: JSON of a layout, named `source` in messages.
/// A value of a flag replaces that of all swimmer types, of the fluid, or both, as beadswim-layout swimmer
/// does. Angular stiffness and resolution follow if they have their defaults. Throws InputError if a pointer
/// leads to nothing or to no single value, if the layout has the quantity in its study already, or if it is
/// invalid with these values.
LayoutDocument with_values(const Json& layout, const StudyPoint& point, const std::string& source);

}  // namespace beadswim
