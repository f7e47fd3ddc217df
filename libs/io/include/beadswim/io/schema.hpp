#pragma once

#include <string>

#include "beadswim/io/json.hpp"

namespace beadswim {

/// Validates a document against the JSON Schema (draft-07) `schema_name`, which is built into the program.
/// For example, "layout" is the file schemas/layout.schema.json. Throws InputError with one line per fault:
/// "source:/json/pointer: value: allowed values". The message suggests the nearest valid name for an unknown
/// key. If the document states another kind of document or another version, the message contains only this
/// fault.
void validate_json(const Json& document, const std::string& schema_name, const std::string& source);

}  // namespace beadswim
