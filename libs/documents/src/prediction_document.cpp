#include "beadswim/documents/prediction_document.hpp"

#include <fmt/core.h>

#include "beadswim/core/error.hpp"
#include "beadswim/documents/layout_document.hpp"
#include "beadswim/io/schema.hpp"
#include "layout_json.hpp"

/// Converts the settings of a prediction to a JSON object and back: one key per setting, in order, with a
/// string or a number as value.
template <>
struct nlohmann::adl_serializer<std::vector<beadswim::Prediction::Setting>> {
  static void to_json(beadswim::Json& json, const std::vector<beadswim::Prediction::Setting>& settings) {
    json = beadswim::Json::object();
    for (const auto& [name, setting] : settings)
      std::visit([&json, &name = name](const auto& value) { json[name] = value; }, setting);
  }
  static void from_json(const beadswim::Json& json, std::vector<beadswim::Prediction::Setting>& settings) {
    for (const auto& [name, value] : json.items()) {
      if (value.is_string()) {
        settings.emplace_back(name, value.get<std::string>());
      } else {
        settings.emplace_back(name, value.get<double>());
      }
    }
  }
};

namespace beadswim {
namespace {

void require_equal_arms(const Prediction& prediction, const std::string& place) {
  const std::size_t arms = prediction.stroke.amplitude.size();
  if (prediction.stroke.phase.size() == arms &&
      (!prediction.arm_means || prediction.arm_means->size() == arms))
    return;
  throw InputError(
      place,
      "the lists arm_amplitudes, arm_phases and arm_means must have the same length; the file was "
      "edited: give the predictions as beadswim-theory wrote them");
}

}  // namespace

Json predictions_to_json(const PredictionDocument& document) {
  Json json{{"schema", "beadswim/prediction/1"}};
  add_fields(json, document);
  if (document.scene) json["scene"] = scene_to_json(*document.scene);
  return json;
}

PredictionDocument predictions_from_json(const Json& json, const std::string& source) {
  validate_json(json, "prediction", source);
  PredictionDocument document = json.get<PredictionDocument>();
  for (std::size_t p = 0; p < document.predictions.size(); ++p)
    require_equal_arms(document.predictions[p], fmt::format("{}:/predictions/{}", source, p));
  if (json.contains("scene")) document.scene = scene_from_json(json["scene"], document.units, source);
  return document;
}

}  // namespace beadswim
