#pragma once

#include <string>

#include "beadswim/io/json.hpp"
#include "beadswim/scene/layout.hpp"

namespace beadswim {

/// A layout and its provenance: one record for each program that made or changed it.
struct LayoutDocument {
  Layout layout;
  Json provenance = Json::array();
};

/// Converts a JSON document to a layout. Validates it against the schema, and checks relations between
/// fields: unknown types, duplicate ids, overlaps, beads outside the box, arms. `source`: name of the
/// document in messages. Throws InputError with all faults.
LayoutDocument layout_from_json(const Json& document, const std::string& source);

/// Reads a layout from a file, or from stdin for "-". Throws InputError.
LayoutDocument read_layout(const std::string& path);

/// Returns the layout as JSON (schemas/layout.schema.json).
Json layout_to_json(const LayoutDocument& document);

}  // namespace beadswim
