#pragma once

#include <string>

#include "beadswim/io/document_stream.hpp"
#include "beadswim/io/json.hpp"
#include "beadswim/scene/layout.hpp"

namespace beadswim {

/// A layout with its provenance, which has one entry for each program that made or changed the layout.
struct LayoutDocument {
  Layout layout;
  Json provenance = Json::array();
  Json made_by{};  ///< object: the command and the parameters that describe the layout; null: none do
  Json study{};  ///< object: value of each varied quantity by its name; null: nothing was varied

  static void visit_fields(auto&& visit, auto& document) {
    Layout::visit_fields(visit, document.layout);
    visit("made_by", document.made_by, omitted_if_none);
    visit("study", document.study, omitted_if_none);
    visit("provenance", document.provenance);
  }
};

/// Converts a JSON document to a layout after validation against the schema. Also checks relations between
/// fields: unknown types, duplicate ids, overlaps, beads outside the box, and arms shorter than the beads
/// that they join. `source`: name of the document in messages. Throws InputError with a list of all faults.
LayoutDocument layout_from_json(const Json& document, const std::string& source);

/// Converts a document of a stream to a layout. Throws the errors of layout_from_json() and parse_json().
LayoutDocument layout_of(const StreamMember& member);

/// Reads a layout from a file, or from stdin for "-". Throws InputError.
LayoutDocument read_layout(const std::string& path);

/// Returns the layout as JSON (schemas/layout.schema.json).
Json layout_to_json(const LayoutDocument& document);

/// Returns the scene of a layout as JSON: the member "scene" of run records and predictions. Its keys are the
/// keys fluid, domain, types and swimmers of a layout document.
Json scene_to_json(const Layout& layout);

/// Converts the member "scene" of a document, with the checks of layout_from_json(). `units`, `source`: units
/// and name of the document.
Layout scene_from_json(const Json& scene, const Units& units, const std::string& source);

/// Returns the text of a value of a study: a word as it is, a number with `digits` significant digits.
std::string study_value_text(const Json& value, int digits);

/// Returns the values of a study as "period = 2400, frame = lab"; empty without a study.
std::string study_text(const Json& study, int digits);

}  // namespace beadswim
