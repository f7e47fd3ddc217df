#include "beadswim/documents/prediction_document.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "beadswim/core/error.hpp"
#include "beadswim/scene/presets.hpp"

namespace beadswim {
namespace {

/// Returns two predictions: the first has no optional member, the second has all.
PredictionDocument two_predictions() {
  Prediction sparse{.method = "oseen-force-closed",
                    .usable = false,
                    .validity = "far beads",
                    .velocity = -1.5e-5,
                    .uncertainty = std::nullopt,
                    .stroke = {.amplitude = {3.25, 0}, .phase = {-0.5, 0}},
                    .stroke_uncertainty = std::nullopt,
                    .sin_phase_shift = 0,
                    .power = std::nullopt,
                    .efficiency = std::nullopt,
                    .arm_means = std::nullopt,
                    .settings = {}};
  Prediction full = sparse;
  full.method = "rpy-perturbation";
  full.usable = true;
  full.uncertainty = 0.1;
  full.power = 2.5e-3;
  full.efficiency = 1.25e-4;
  full.stroke_uncertainty = StrokeUncertainty{.arm_amplitudes = {0.01, 0.02}, .sin_phase_shift = 0.003};
  full.arm_means = {20.01, 19.99};
  full.settings = {{"fluid", "unbounded"}, {"period", 4800.0}};
  const Units units{.lattice = false, .length = {"um", 1e-6}, .time = {"ms", 1e-3}, .mass = {"pg", 1e-15}};
  PredictionDocument document{{.units = units,
                               .swimmer = 7,
                               .predictions = {sparse, full},
                               .left_out = {{"rpy-ode", "contact"}},
                               .warnings = {"large"}}};
  document.scene = paper_single();
  return document;
}

// Whatever is written is read back bit by bit, so writing it again gives the same bytes.
TEST(PredictionDocument, SurvivesWritingAndReading) {
  const std::string written = dump_json(predictions_to_json(two_predictions()));
  const PredictionDocument read = predictions_from_json(parse_json(written, "test"), "test");
  EXPECT_EQ(dump_json(predictions_to_json(read)), written);
  EXPECT_EQ(read.swimmer, 7);
  EXPECT_EQ(read.scene->units.time.si_factor, 1e-3);
  EXPECT_EQ(read.units.time.si_factor, 1e-3);
  EXPECT_FALSE(read.predictions[0].usable);
  EXPECT_FALSE(read.predictions[0].arm_means.has_value());
  EXPECT_EQ(read.predictions[1].uncertainty, 0.1);
  EXPECT_EQ(read.predictions[1].stroke_uncertainty->arm_amplitudes[1], 0.02);
  EXPECT_EQ(read.left_out.at(0).reason, "contact");
  EXPECT_EQ(read.warnings, std::vector<std::string>{"large"});
  EXPECT_EQ(read.predictions[1].settings, two_predictions().predictions[1].settings);
}

TEST(PredictionDocument, OnOneLineIsTheSameDocument) {
  const Json document = predictions_to_json(two_predictions());
  const std::string line = dump_json_line(document);
  EXPECT_EQ(line.find('\n'), line.size() - 1);
  EXPECT_EQ(parse_json(line, "test"), document);
}

std::string fault_of(const Json& document) {
  try {
    predictions_from_json(document, "test");
    return "";
  } catch (const InputError& error) {
    return error.what();
  }
}

TEST(PredictionDocument, RefusesWhatTheSchemaForbidsAndSaysWhere) {
  Json document = predictions_to_json(two_predictions());
  document["predictions"][0]["velocitty"] = 1;
  EXPECT_THAT(fault_of(document), testing::HasSubstr("/predictions/0"));
  document = predictions_to_json(two_predictions());
  document["predictions"][1]["sin_phase_shift"] = 1.5;
  EXPECT_THAT(fault_of(document), testing::HasSubstr("/predictions/1/sin_phase_shift"));
  document = predictions_to_json(two_predictions());
  document["predictions"][1]["arm_means"] = {20.0};
  EXPECT_THAT(fault_of(document),
              testing::HasSubstr("/predictions/1: the lists arm_amplitudes, arm_phases and arm_means"));
}

// A NaN must never reach a file: JSON has no word for it.
TEST(PredictionDocument, RefusesToWriteNaN) {
  PredictionDocument document = two_predictions();
  document.predictions[0].velocity = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(dump_json_line(predictions_to_json(document)), SolverError);
}

}  // namespace
}  // namespace beadswim
