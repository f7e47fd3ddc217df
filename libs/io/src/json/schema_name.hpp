#pragma once

#include <string>

#include "beadswim/io/json.hpp"

namespace beadswim {

/// Checks that the value of the key "schema" is the expected name and version, for example
/// "beadswim/layout/1". Throws InputError otherwise. The message states the actual kind of the document, or
/// that its version is newer than the program.
void check_schema_name(const Json& document, const std::string& expected, const std::string& source);

}  // namespace beadswim
