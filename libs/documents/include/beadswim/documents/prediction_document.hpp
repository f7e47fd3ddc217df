#pragma once

#include <string>
#include <vector>

#include "beadswim/io/fields_json.hpp"
#include "beadswim/scene/layout.hpp"
#include "beadswim/theory/prediction.hpp"

namespace beadswim {

/// A theory method that cannot treat the swimmer, and the reason.
struct LeftOutMethod {
  std::string method;
  std::string reason;

  static void visit_fields(auto&& visit, auto& left_out) {
    visit("method", left_out.method);
    visit("reason", left_out.reason);
  }
};

/// Returns the number with this key in the settings of a prediction; nullopt if there is none.
std::optional<double> number_setting(const Prediction& prediction, const std::string& key);

/// Predictions for one swimmer of a layout (schemas/prediction.schema.json).
struct PredictionDocument {
  Units units;      ///< units of the layout, used for all quantities of this document
  int swimmer = 0;  ///< id of the swimmer in the layout
  std::vector<Prediction> predictions;
  std::vector<LeftOutMethod> left_out;
  std::vector<std::string> warnings;  ///< beads that touch, or driving too strong for some methods
  Json provenance = Json::array();    ///< one entry per program that made the document
  Json study{};                       ///< study of the layout (layout_document.hpp)
  std::optional<Layout> scene{};      ///< nullopt for large swarms, or if unknown

  static void visit_fields(auto&& visit, auto& document) {  // scene_to_json() converts `scene`
    visit("units", document.units);
    visit("swimmer", document.swimmer);
    visit("predictions", document.predictions);
    visit("left_out", document.left_out);
    visit("warnings", document.warnings);
    visit("study", document.study, omitted_if_none);
    visit("provenance", document.provenance);
  }
};

/// Returns the document as JSON.
Json predictions_to_json(const PredictionDocument& document);

/// Converts a JSON document to predictions after validation against the schema. `source`: name of the
/// document in messages. Throws InputError if the document is invalid.
PredictionDocument predictions_from_json(const Json& document, const std::string& source);

}  // namespace beadswim
