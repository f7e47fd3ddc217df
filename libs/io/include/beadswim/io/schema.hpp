#pragma once

#include <string>

#include "beadswim/io/json.hpp"

namespace beadswim {

/// Validates a document against an embedded JSON Schema (draft-07). The schema "layout" is the file
/// schemas/layout.schema.json. Throws InputError with one line per fault: "source:/json/pointer: value:
/// allowed values". The message suggests the nearest valid name for an unknown key. Another schema name or a
/// newer version has its own message.
void validate_json(const Json& document, const std::string& schema_name, const std::string& source);

}  // namespace beadswim
