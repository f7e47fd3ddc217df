#include "beadswim/documents/prediction_document.hpp"

#include "beadswim/io/schema.hpp"
#include "nullable_json.hpp"
#include "units_json.hpp"

namespace beadswim {
namespace {

using ArmNumbers = std::array<double, 2>;

Json settings_to_json(const std::vector<Prediction::Setting>& settings) {
  Json json = Json::object();
  for (const auto& [name, setting] : settings) {
    std::visit([&json, &name = name](const auto& value) { json[name] = value; }, setting);
  }
  return json;
}

std::vector<Prediction::Setting> settings_from_json(const Json& json) {
  std::vector<Prediction::Setting> settings;
  for (const auto& [name, value] : json.items()) {
    if (value.is_string()) {
      settings.emplace_back(name, value.get<std::string>());
    } else {
      settings.emplace_back(name, value.get<double>());
    }
  }
  return settings;
}

Json stroke_uncertainty_to_json(const std::optional<StrokeUncertainty>& uncertainty) {
  if (!uncertainty) return nullptr;
  return {{"arm_amplitudes", uncertainty->arm_amplitudes}, {"sin_phase_shift", uncertainty->sin_phase_shift}};
}

std::optional<StrokeUncertainty> stroke_uncertainty_from_json(const Json& prediction) {
  const auto found = prediction.find("stroke_uncertainty");
  if (found == prediction.end() || found->is_null()) return std::nullopt;
  return StrokeUncertainty{.arm_amplitudes = found->at("arm_amplitudes").get<ArmNumbers>(),
                           .sin_phase_shift = found->at("sin_phase_shift").get<double>()};
}

Json prediction_to_json(const Prediction& prediction) {
  return {{"method", prediction.method},
          {"usable", prediction.usable},
          {"validity", prediction.validity},
          {"velocity", prediction.velocity},
          {"uncertainty", json_or_null(prediction.uncertainty)},
          {"arm_amplitudes", prediction.stroke.amplitude},
          {"arm_phases", prediction.stroke.phase},
          {"sin_phase_shift", prediction.sin_phase_shift},
          {"stroke_uncertainty", stroke_uncertainty_to_json(prediction.stroke_uncertainty)},
          {"arm_means", json_or_null(prediction.arm_means)},
          {"settings", settings_to_json(prediction.settings)}};
}

Prediction prediction_from_json(const Json& json) {
  return {.method = json.at("method").get<std::string>(),
          .usable = json.at("usable").get<bool>(),
          .validity = json.at("validity").get<std::string>(),
          .velocity = json.at("velocity").get<double>(),
          .uncertainty = value_unless_null<double>(json.at("uncertainty")),
          .stroke = {.amplitude = json.at("arm_amplitudes").get<ArmNumbers>(),
                     .phase = json.at("arm_phases").get<ArmNumbers>()},
          .stroke_uncertainty = stroke_uncertainty_from_json(json),
          .sin_phase_shift = json.at("sin_phase_shift").get<double>(),
          .arm_means = value_unless_null<ArmNumbers>(json.at("arm_means")),
          .settings = settings_from_json(json.at("settings"))};
}

}  // namespace

Json predictions_to_json(const PredictionDocument& document) {
  Json predictions = Json::array();
  for (const Prediction& prediction : document.predictions)
    predictions.push_back(prediction_to_json(prediction));
  Json left_out = Json::array();
  for (const auto& [method, reason] : document.left_out) {
    left_out.push_back({{"method", method}, {"reason", reason}});
  }
  return {{"schema", "beadswim/prediction/1"},
          {"units", units_to_json(document.units)},
          {"swimmer", document.swimmer},
          {"predictions", predictions},
          {"left_out", left_out},
          {"warnings", document.warnings},
          {"provenance", document.provenance}};
}

PredictionDocument predictions_from_json(const Json& json, const std::string& source) {
  validate_json(json, "prediction", source);
  PredictionDocument document;
  document.units = units_from_json(json.at("units"));
  document.swimmer = json.at("swimmer").get<int>();
  for (const Json& prediction : json.at("predictions")) {
    document.predictions.push_back(prediction_from_json(prediction));
  }
  for (const Json& method : json.value("left_out", Json::array())) {
    document.left_out.push_back(
        {method.at("method").get<std::string>(), method.at("reason").get<std::string>()});
  }
  document.warnings = json.value("warnings", std::vector<std::string>());
  document.provenance = json.value("provenance", Json::array());
  return document;
}

PredictionDocument read_predictions(const std::string& path) {
  const std::string source = path == "-" ? "standard input" : path;
  return predictions_from_json(parse_json(read_text(path), source), source);
}

}  // namespace beadswim
