#pragma once

#include <string>
#include <utility>
#include <vector>

#include "beadswim/documents/layout_document.hpp"

// Quantities of layouts that a study varies, or whose best values are searched.

namespace beadswim {

/// Returns the name of a quantity: that of a NamedQuantity, also with -- before it, or a JSON pointer into
/// the layout. Throws InputError with the nearest name if the text is neither. `flag`: flag of the command
/// line for the message.
std::string quantity_name(const std::string& text, const std::string& flag);

/// Values of the quantities of a study, by name: numbers (angles in radian) or words.
using StudyPoint = std::vector<std::pair<std::string, Json>>;

/// Returns the layout with the values of `point`. `layout`: JSON of a layout, named `source` in messages.
/// Named quantities are set by set_quantities(). Throws InputError if a named quantity cannot have its value
/// or changes no swimmer, if a pointer leads to nothing or to no single value, if the layout has the quantity
/// in its study already, or if it is invalid with these values. `flag`: flag of the command line that named
/// the quantities, for messages.
LayoutDocument with_values(const Json& layout, const StudyPoint& point, const std::string& source,
                           const std::string& flag);

}  // namespace beadswim
