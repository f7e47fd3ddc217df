#pragma once

#include <string>

#include "beadswim/io/json.hpp"
#include "beadswim/scene/layout.hpp"

namespace beadswim {

/// A layout and its provenance: one entry for each program that made or changed it.
struct LayoutDocument {
  Layout layout;
  Json provenance = Json::array();
};

/// Converts a JSON document to a layout. It validates the document against the schema. It also checks
/// relations between fields: unknown types, duplicate ids, overlaps, beads outside the box, and arms shorter
/// than the beads they join. `source`: name of the document in messages. Throws InputError that lists all
/// faults.
LayoutDocument layout_from_json(const Json& document, const std::string& source);

/// Reads a layout from a file, or from stdin for "-". Throws InputError.
LayoutDocument read_layout(const std::string& path);

/// Returns the layout as JSON (schemas/layout.schema.json).
Json layout_to_json(const LayoutDocument& document);

}  // namespace beadswim
