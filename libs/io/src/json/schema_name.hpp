#pragma once

#include <string>

#include "beadswim/io/json.hpp"

namespace beadswim {

/// Checks the document's key "schema" against the name and version expected, such as "beadswim/layout/1".
/// Throws InputError that says what the document is instead, or that it is newer than the program.
void check_schema_name(const Json& document, const std::string& expected, const std::string& source);

}  // namespace beadswim
