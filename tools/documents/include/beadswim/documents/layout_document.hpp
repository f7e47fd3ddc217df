#pragma once

#include <string>

#include "beadswim/io/json.hpp"
#include "beadswim/scene/layout.hpp"

namespace beadswim {

/// A layout and the records of the programs that made it.
struct LayoutDocument {
  Layout layout;
  Json provenance = Json::array();
};

/// Validates against the schema, checks across fields (unknown types, duplicate ids, overlaps, beads outside
/// the box, arms) and converts. `source` names the document in messages. Throws InputError.
LayoutDocument layout_from_json(const Json& document, const std::string& source);

/// Reads a file, or stdin for "-". Throws InputError.
LayoutDocument read_layout(const std::string& path);

Json layout_to_json(const LayoutDocument& document);

}  // namespace beadswim
