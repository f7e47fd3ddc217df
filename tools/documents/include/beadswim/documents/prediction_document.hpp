#pragma once

#include <string>
#include <vector>

#include "beadswim/io/fields_json.hpp"
#include "beadswim/scene/layout.hpp"
#include "beadswim/theory/prediction.hpp"

namespace beadswim {

/// A method that could not treat the swimmer, with the reason.
struct LeftOutMethod {
  std::string method;
  std::string reason;

  static void visit_fields(auto&& visit, auto& left_out) {
    visit("method", left_out.method);
    visit("reason", left_out.reason);
  }
};

/// Predictions for one swimmer of a layout (schemas/prediction.schema.json).
struct PredictionDocument {
  Units units;      ///< units of the layout and of all quantities here
  int swimmer = 0;  ///< id of the swimmer in the layout
  std::vector<Prediction> predictions;
  std::vector<LeftOutMethod> left_out;
  std::vector<std::string> warnings;  ///< contact within the stroke, driving beyond small amplitude
  Json provenance = Json::array();    ///< one record per program
};

/// Returns the document as JSON.
Json predictions_to_json(const PredictionDocument& document);

/// Converts JSON after validation against the schema. `source`: name of the document in messages. Throws
/// InputError.
PredictionDocument predictions_from_json(const Json& document, const std::string& source);

/// Reads predictions from a file, or from stdin for "-". Throws InputError.
PredictionDocument read_predictions(const std::string& path);

}  // namespace beadswim
