#pragma once

#include <string>
#include <vector>

#include "beadswim/io/json.hpp"

// Looks up what a JSON Schema (draft-07) says of one value: the subschemas that apply to it, through
// properties, additionalProperties, items, $ref, allOf, anyOf, oneOf and if/then/else.

namespace beadswim {

using Subschemas = std::vector<const Json*>;

/// The subschemas of `root` that apply to the whole document. Of if/then/else, the branch that the value
/// takes is followed when the condition is on its type alone; otherwise both are.
Subschemas document_schemas(const Json& root, const Json& document);

/// The subschemas that apply to a member (by its key) or element (by its index) of a value to which `parents`
/// apply; `value` is that member, or nullptr if it is missing.
Subschemas member_schemas(const Json& root, const Subschemas& parents, const std::string& key,
                          const Json* value);

/// The first subschema's entry for a keyword, or nullptr.
const Json* find_keyword(const Subschemas& schemas, const std::string& keyword);

/// The names under "properties" in all the subschemas.
std::vector<std::string> property_names(const Subschemas& schemas);

}  // namespace beadswim
