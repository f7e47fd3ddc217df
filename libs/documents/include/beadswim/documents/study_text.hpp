#pragma once

#include <string>

#include "beadswim/io/json.hpp"

// Text for the values of a study (layout_document.hpp), which are numbers or words.

namespace beadswim {

/// Returns a word as it is, and a number with `digits` significant digits.
std::string study_value_text(const Json& value, int digits);

/// Returns the values of a study as "period = 2400, frame = lab"; empty without a study.
std::string study_text(const Json& study, int digits);

}  // namespace beadswim
