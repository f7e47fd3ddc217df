#pragma once

#include <string>
#include <vector>

#include "beadswim/io/json.hpp"

// Finds the subschemas of a JSON Schema (draft-07) that apply to one value. Follows properties,
// additionalProperties, items, $ref, allOf, anyOf, oneOf and if/then/else.

namespace beadswim {

using Subschemas = std::vector<const Json*>;

/// Returns the subschemas of `root` that apply to the complete document. If the condition of an if/then/else
/// is only on the type of the value, one branch is followed, otherwise both.
Subschemas document_schemas(const Json& root, const Json& document);

/// Returns the subschemas that apply to a member or an element of a value to which `parents` apply. `key` is
/// the key of the member or the index of the element. `value` is the member or element, or nullptr if it is
/// missing.
Subschemas member_schemas(const Json& root, const Subschemas& parents, const std::string& key,
                          const Json* value);

/// Returns the entry for a keyword in the first subschema that has one, or nullptr.
const Json* find_keyword(const Subschemas& schemas, const std::string& keyword);

/// Returns the names in the "properties" of all given subschemas.
std::vector<std::string> property_names(const Subschemas& schemas);

}  // namespace beadswim
