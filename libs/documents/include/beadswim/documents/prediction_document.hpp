#pragma once

#include <string>
#include <vector>

#include "beadswim/io/fields_json.hpp"
#include "beadswim/theory/layout_predictions.hpp"

namespace beadswim {

/// Returns the value of this type with this key in the settings of a prediction; nullopt if there is none.
template <class Value>
std::optional<Value> find_setting(const Prediction& prediction, const std::string& key) {
  for (const auto& [name, value] : prediction.settings)
    if (name == key && std::holds_alternative<Value>(value)) return std::get<Value>(value);
  return std::nullopt;
}

/// Predictions for one swimmer of a layout (schemas/prediction.schema.json).
struct PredictionDocument : LayoutPredictions {
  Json provenance = Json::array();  ///< one entry per program that made the document
  Json study{};                     ///< study of the layout (layout_document.hpp)
  std::optional<Layout> scene{};    ///< nullopt for large swarms, or if unknown

  // scene_to_json() converts `scene`.
  BEADSWIM_FIELDS(units, swimmer, predictions, left_out, warnings, (study, omitted_if_none), provenance)
};

/// Returns the document as JSON.
Json predictions_to_json(const PredictionDocument& document);

/// Converts a JSON document to predictions after validation against the schema. `source`: name of the
/// document in messages. Throws InputError if the document is invalid.
PredictionDocument predictions_from_json(const Json& document, const std::string& source);

}  // namespace beadswim
