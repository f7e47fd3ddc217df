#pragma once

#include <string>

#include "beadswim/io/json.hpp"

namespace beadswim {

/// Validates against an embedded JSON Schema (draft-07): name "layout" is schemas/layout.schema.json.
/// Throws InputError with one line a fault: "source:/json/pointer: value: what is allowed", with the nearest
/// valid name for an unknown key and a clear message for another schema name or a newer version.
void validate_json(const Json& document, const std::string& schema_name, const std::string& source);

}  // namespace beadswim
