#pragma once

#include <string>
#include <utility>
#include <vector>

#include "beadswim/documents/layout_document.hpp"

// Quantities of layouts that a study varies, or whose best values are searched. A study consists of layouts
// that differ in the values of a few quantities.

namespace beadswim {

/// Returns the name of a quantity: that of a NamedQuantity, also with -- before it, or a JSON pointer into
/// the layout. Throws InputError with the nearest name if the text is neither. `flag`: flag of the command
/// line for the message.
std::string quantity_name(const std::string& text, const std::string& flag);

/// Values of the quantities of a study, by name: numbers (angles in radian) or words.
using StudyPoint = std::vector<std::pair<std::string, Json>>;

/// Returns the layout with the values of `point`, without made_by. `layout`: JSON of a layout, named `source`
/// in messages. Named quantities are set by set_quantities(); /swimmers/N/rotate/x, y or z turns a swimmer
/// about its position by an angle about this axis [radian]. Throws InputError if a named quantity cannot have
/// its value or changes no swimmer, if a pointer leads to nothing or to no single value, if the layout has
/// the quantity in its study already, or if it is invalid with these values. `flag`: flag of the command line
/// that named the quantities, for messages. `present`: values of further quantities that the layout has
/// already, for its study and messages.
LayoutDocument with_values(const Json& layout, const StudyPoint& point, const std::string& source,
                           const std::string& flag, const StudyPoint& present = {});

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
