#pragma once

#include <string>
#include <vector>

#include "beadswim/io/fields_json.hpp"
#include "beadswim/scene/layout.hpp"
#include "beadswim/theory/prediction.hpp"

namespace beadswim {

/// A method of `all` that could not treat the swimmer, and why.
struct LeftOutMethod {
  std::string method;
  std::string reason;

  static void visit_fields(auto&& visit, auto& left_out) {
    visit("method", left_out.method);
    visit("reason", left_out.reason);
  }
};

/// What theory says of one swimmer of a layout (schemas/prediction.schema.json).
struct PredictionDocument {
  Units units;      ///< the layout's; all quantities are in them
  int swimmer = 0;  ///< id of the swimmer in the layout
  std::vector<Prediction> predictions;
  std::vector<LeftOutMethod> left_out;
  std::vector<std::string> warnings;  ///< of contact within the stroke, and of driving beyond small amplitude
  Json provenance = Json::array();    ///< one record a program
};

Json predictions_to_json(const PredictionDocument& document);

/// Validates against the schema and converts. `source` names the document in messages. Throws InputError.
PredictionDocument predictions_from_json(const Json& document, const std::string& source);

/// Reads a file, or stdin for "-". Throws InputError.
PredictionDocument read_predictions(const std::string& path);

}  // namespace beadswim
