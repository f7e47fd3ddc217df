#include "beadswim/documents/swimming_document.hpp"

#include <gtest/gtest.h>

#include "beadswim/core/error.hpp"
#include "beadswim/scene/presets.hpp"
#include "three_bead_types.hpp"

namespace beadswim {
namespace {

/// Returns the record of a run of two swimmers, the second with the period 2000, without a scene:
/// without scene.
RunRecord older_record() {
  RunRecord record;
  record.model = "lbm";
  record.domain.box = paper_single().domain.box;
  record.driving = {.period = 4800, .amplitude = {{0.2, 0.2}}, .phase = 1.5};
  record.swimmers = {{.id = 0, .cycles = {}, .period = {}}, {.id = 7, .cycles = {}, .period = 2000}};
  return record;
}

/// Returns the prediction for swimmer 7, without a scene.
PredictionDocument older_prediction() {
  Prediction prediction{};
  prediction.settings = {{"period", 2000.0}, {"amplitude", 0.2}, {"amplitude_ratio", 1.0}, {"phase", 1.5}};
  PredictionDocument document;
  document.swimmer = 7;
  document.predictions = {prediction};
  return document;
}

Layout layout_of_two() {
  Layout layout = paper_single();
  change(layout.types["a"].driving, [](ThreeBeadDriving& driving) { driving.phase = 1.5; });
  layout.swimmers.push_back({.id = 7, .type = "a", .position = Vec3(100, 400, 400)});
  layout.swimmers[1].driving = layout.types["a"].driving;
  layout.swimmers[1].driving->period = 2000;
  return layout;
}

using Differences = std::vector<SceneDifference>;

// Would catch a difference that is found only because one document does not state a property.
TEST(ScenesOfDocuments, OlderDocumentsAgree) {
  RunRecord record = older_record();
  PredictionDocument prediction = older_prediction();
  EXPECT_EQ(scene_differences(record, record), Differences{});
  EXPECT_EQ(scene_differences(record, prediction), Differences{});
  prediction.predictions.clear();
  EXPECT_EQ(scene_differences(record, prediction), Differences{});
  prediction.scene = layout_of_two();
  EXPECT_EQ(scene_differences(record, prediction), Differences{});
  record.scene = layout_of_two();
  EXPECT_EQ(scene_differences(record, prediction), Differences{});
  EXPECT_EQ(scene_differences(record, older_record()), Differences{});
  EXPECT_EQ(scene_differences(record, older_prediction()), Differences{});
}

TEST(ScenesOfDocuments, OlderDocumentsAreComparedByWhatTheyState) {
  PredictionDocument prediction = older_prediction();
  prediction.predictions[0].settings = {{"period", 1000.0}, {"amplitude", 0.3}, {"phase", 1.0}};
  const Differences expected{
      {"period", "2000", "1000"}, {"amplitude", "0.2", "0.3, 0"}, {"phase", "1.5", "1"}};
  EXPECT_EQ(scene_differences(older_record(), prediction), expected);
}

TEST(ScenesOfDocuments, AnOlderRunIsComparedWithAScene) {
  PredictionDocument prediction = older_prediction();
  prediction.scene = layout_of_two();
  prediction.scene->domain.box.reset();
  prediction.scene->swimmers.erase(prediction.scene->swimmers.begin());
  const Differences expected{{"domain", "1200 x 800 x 800, free-slip, free-slip, free-slip", "open space"},
                             {"swimmers", "2 with id 0 to 7", "1 with id 7"}};
  EXPECT_EQ(scene_differences(older_record(), prediction), expected);
}

// A ratio A/B of 0 does not state B.
TEST(ScenesOfDocuments, AnAmplitudeOfZeroLeavesTheOtherUnknown) {
  RunRecord record = older_record();
  record.driving.amplitude = {{0, 0.2}};
  PredictionDocument prediction = older_prediction();
  prediction.predictions[0].settings = {{"amplitude", 0.0}, {"amplitude_ratio", 0.0}};
  EXPECT_EQ(scene_differences(record, prediction), Differences{});
}

// Swimmers other than the predicted one belong to the scene too.
TEST(ScenesOfDocuments, TwoScenesAreComparedInFull) {
  RunRecord record = older_record();
  PredictionDocument prediction = older_prediction();
  record.scene = prediction.scene = layout_of_two();
  prediction.scene->fluid.density = 2;
  prediction.scene->swimmers[0].axis = Vec3::UnitY();
  const Differences expected{
      {"fluid", "density 1, viscosity 0.3333333333333333", "density 2, viscosity 0.3333333333333333"},
      {"placing", "swimmer 0 with axis (1, 0, 0)", "swimmer 0 with axis (0, 1, 0)"}};
  EXPECT_EQ(scene_differences(record, prediction), expected);
}

}  // namespace
}  // namespace beadswim
