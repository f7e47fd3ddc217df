#pragma once

#include <string>
#include <vector>

#include "beadswim/io/json.hpp"

namespace beadswim {

/// Validates a document against the JSON Schema (draft-07) `schema_name`, which is built into the program.
/// For example, "layout" is the file schemas/layout.schema.json. Throws InputError with one line per fault:
/// "source:/json/pointer: value: allowed values". The message suggests the nearest valid name for an unknown
/// key. If the document states another kind of document or another version, the message contains only this
/// fault.
void validate_json(const Json& document, const std::string& schema_name, const std::string& source);

/// An invalid value in a document.
struct DocumentFault {
  std::string pointer;  ///< JSON pointer (RFC 6901) to the value; "" refers to the complete document
  std::string message;  ///< states the invalid value, the allowed values and the remedy
};

/// Throws InputError if there are faults. The message has one line "source:/pointer: message" for each of the
/// first twenty faults. If there are more faults, the last line states how many.
void throw_if_faulty(const std::string& source, const std::vector<DocumentFault>& faults);

}  // namespace beadswim
