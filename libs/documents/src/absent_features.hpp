#pragma once

#include <string>

#include "beadswim/io/json.hpp"

namespace beadswim {

/// Throws InputError for the first key of a layout that requests physics which this version does not have,
/// such as an imposed flow or a prescribed stroke. Other unknown keys are reported by the schema validation.
void refuse_absent_features(const Json& layout, const std::string& source);

}  // namespace beadswim
