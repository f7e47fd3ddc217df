#pragma once

#include <string>

#include "beadswim/io/json.hpp"

namespace beadswim {

/// Throws InputError if the key "schema" of the document does not have the value `expected`, for example
/// "beadswim/layout/1". The message then states the actual kind of the document, or that its version is not
/// the version that this program reads.
void check_schema_name(const Json& document, const std::string& expected, const std::string& source);

}  // namespace beadswim
