#include "beadswim/documents/swimming_document.hpp"

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
  Layout stated;
  stated.domain = run.domain;
  stated.flow = run.flow.value_or(BackgroundFlow{});
  stated.body_force = run.body_force.value_or(Vec3::Zero());
  for (const int each : swimmers_of(run)) stated.swimmers.emplace_back().id = each;
  SceneProperties properties = common_properties(stated);
  properties.erase("fluid");
  DrivingRecord driving = run.driving;
  const auto swimmer = std::ranges::find(run.swimmers, id, &SwimmerRecord::id);
  if (swimmer != run.swimmers.end()) driving.period = swimmer->period.value_or(driving.period);
  std::vector<FieldLeaf> leaves = leaves_of(driving, "/driving");
  std::erase_if(leaves, [](const FieldLeaf& leaf) { return leaf.word == "none"; });
  properties.merge(properties_of(leaves));
  return properties;
}

/// Returns the driving that a prediction document without scene states in the settings of its methods, for
/// the only swimmer of the document.
SceneProperties stated_properties(const PredictionDocument& document, int /*id*/) {
  SceneProperties properties;
  const auto state = [&](const char* field, const std::vector<std::optional<double>>& numbers) {
    std::vector<FieldLeaf> leaves;
    for (const auto& number : numbers)
      leaves.push_back({"/driving/" + std::string(field), number.value_or(0)});
    if (!numbers.front()) return;
    SceneProperties stated = properties_of(leaves);
    stated.merge(properties);
    properties = std::move(stated);
  };
  for (const Prediction& prediction : document.predictions) {
    state("period", {find_setting<double>(prediction, "period")});
    state("phase", {find_setting<double>(prediction, "phase")});
    const auto amplitude = find_setting<double>(prediction, "amplitude"),
               ratio = find_setting<double>(prediction, "amplitude_ratio");
    if (ratio != 0)  // a ratio of 0 does not state B
      state("amplitude", {amplitude, amplitude && ratio ? *amplitude / *ratio : std::optional<double>()});
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
  return differences;
}

std::string in_words(const SceneDifference& difference) {
  return fmt::format("{} {} instead of {}", difference.name, difference.reference, difference.run);
}

}  // namespace beadswim
