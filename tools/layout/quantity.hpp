#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "beadswim/documents/layout_document.hpp"

// Quantities of layouts that a study varies, or whose best values are searched.

namespace beadswim {

/// Returns the name of a quantity: a flag of beadswim-layout swimmer without --, or a JSON pointer into the
/// layout. Throws InputError with the nearest name if the text is neither. `flag`: flag of the command line
/// for the message.
std::string quantity_name(const std::string& text, const std::string& flag);

/// Returns the number, an angle with the ending deg in radian; nullopt if the text is no finite number.
std::optional<double> quantity_value(const std::string& text);

/// Values of the quantities of a study, by name: numbers (angles in radian) or words.
using StudyPoint = std::vector<std::pair<std::string, Json>>;

/// Returns the layout with the values of `point`. `layout`: JSON of a layout, named `source` in messages.
/// A value of a flag replaces that of all swimmer types, of the fluid, or both, as beadswim-layout swimmer
/// does. Angular stiffness and resolution follow if they have their defaults. Throws InputError if a pointer
/// leads to nothing or to no single value, if the layout has the quantity in its study already, or if it is
/// invalid with these values. `flag`: flag of the command line that named the quantities, for messages.
LayoutDocument with_values(const Json& layout, const StudyPoint& point, const std::string& source,
                           const std::string& flag);

}  // namespace beadswim
