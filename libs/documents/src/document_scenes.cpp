#include "beadswim/documents/document_scenes.hpp"

#include <fmt/core.h>

#include <algorithm>

namespace beadswim {
namespace {

const std::optional<Layout>& scene_of(const SwimmingDocument& document) {
  return std::visit([](const auto& any) -> const std::optional<Layout>& { return any.scene; }, document);
}

/// Returns the properties of a scene and of one of its swimmers.
SceneProperties properties_of(const Layout& scene, int id) {
  SceneProperties properties = common_properties(scene);
  const auto swimmer = std::ranges::find(scene.swimmers, id, &Swimmer::id);
  if (swimmer != scene.swimmers.end()) properties.merge(swimmer_properties(scene.resolved_type(*swimmer)));
  return properties;
}

/// Returns the properties that a run record without scene states of a swimmer. The swimmer has the base
/// period if the record does not list it.
SceneProperties stated_properties(const RunRecord& run, int id) {
  const auto swimmer = std::ranges::find(run.swimmers, id, &SwimmerRecord::id);
  const bool has_period = swimmer != run.swimmers.end() && swimmer->period;
  SceneProperties properties{
      {SceneProperty::domain, domain_value(run.domain)},
      {SceneProperty::flow, flow_value(run.flow.value_or(BackgroundFlow{}))},
      {SceneProperty::body_force, body_force_value(run.body_force.value_or(Vec3::Zero()))},
      {SceneProperty::swimmers, swimmers_value(swimmers_of(run))},
      {SceneProperty::period, numbers_value({has_period ? *swimmer->period : run.driving.period})}};
  if (const auto& amplitude = run.driving.amplitude)
    properties[SceneProperty::amplitude] = numbers_value({amplitude->front(), amplitude->back()});
  if (run.driving.phase) properties[SceneProperty::phase] = numbers_value({*run.driving.phase});
  return properties;
}

/// Returns the driving that a prediction document without scene states in the settings of its methods, for
/// the only swimmer of the document.
SceneProperties stated_properties(const PredictionDocument& document, int /*id*/) {
  SceneProperties properties;
  for (const Prediction& prediction : document.predictions) {
    if (const auto period = number_setting(prediction, "period"))
      properties[SceneProperty::period] = numbers_value({*period});
    if (const auto phase = number_setting(prediction, "phase"))
      properties[SceneProperty::phase] = numbers_value({*phase});
    const auto amplitude = number_setting(prediction, "amplitude"),
               ratio = number_setting(prediction, "amplitude_ratio");
    if (amplitude && ratio.value_or(1) != 0)  // a ratio of 0 does not state B
      properties[SceneProperty::amplitude] = numbers_value({*amplitude, ratio ? *amplitude / *ratio : 0});
  }
  return properties;
}

SceneProperties properties_of(const auto& document, int id) {
  return document.scene ? properties_of(*document.scene, id) : stated_properties(document, id);
}

}  // namespace

std::vector<SceneDifference> scene_differences(const RunRecord& run, const SwimmingDocument& reference) {
  const std::optional<Layout>& scene = scene_of(reference);
  if (run.scene && scene) return scene_differences(*run.scene, *scene);
  std::vector<SceneDifference> differences;
  for (const int id : swimmers_of(reference)) {
    const auto other = std::visit([id](const auto& any) { return properties_of(any, id); }, reference);
    add_differences(differences, properties_of(run, id), other);
  }
  std::ranges::sort(differences, {}, &SceneDifference::property);
  return differences;
}

std::string in_words(const SceneDifference& difference) {
  return fmt::format("{} {} instead of {}", to_text(difference.property), difference.reference,
                     difference.run);
}

}  // namespace beadswim
