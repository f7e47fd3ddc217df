#include "beadswim/documents/results.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "beadswim/core/error.hpp"
#include "beadswim/documents/verdict_document.hpp"
#include "beadswim/io/schema.hpp"
#include "beadswim/scene/presets.hpp"
#include "beadswim/scene/units.hpp"

namespace beadswim {
namespace {

/// A run of the paper's swimmer (arms of 20, radius 4) with two cycles.
RunRecord some_run() {
  RunRecord run;
  run.scene = paper_single();
  run.domain = Domain{};
  CycleStatistics cycle;
  cycle.index = 1;
  cycle.velocity = Vec3(5, 2, 1);
  cycle.axis = Vec3(0.6, 0.8, 0);
  cycle.angular_velocity = Vec3(0, 3, 4);
  cycle.arm_amplitudes = {2, 10};
  cycle.arm_phases = {2.0, 0.5};
  cycle.arm_means = {20, 20};
  cycle.power = 1;
  cycle.efficiency = 0.5;
  cycle.dipole = ForceDipole{.axial = -7, .tensor = {}};
  CycleStatistics last = cycle;
  last.index = 2;
  last.arm_amplitudes = {4, 6};
  last.power = 3;
  run.swimmers.push_back({.id = 0, .cycles = {cycle, last}, .period = {}});
  return run;
}

Results results_of(const RunRecord& run, const CycleChoice& choice) {
  return results_of(run, run.swimmers.front(), choice, "r.json");
}

std::vector<double> numbers(const Results& results, ResultQuantity quantity) {
  return results.at(quantity).numbers;
}

TEST(ResultsOfARun, AreThoseOfItsCycle) {
  const Results results = results_of(some_run(), {});
  constexpr std::size_t of_noise = 3;
  EXPECT_EQ(results.size(), result_rows.size() - of_noise);
  EXPECT_DOUBLE_EQ(numbers(results, ResultQuantity::velocity)[0], 0.6 * 5 + 0.8 * 2);
  EXPECT_EQ(results.at(ResultQuantity::velocity).vector, Vec3(5, 2, 1));
  EXPECT_EQ(numbers(results, ResultQuantity::velocity_z), std::vector{1.0});
  EXPECT_DOUBLE_EQ(numbers(results, ResultQuantity::speed_along_axis)[0], 0.6 * 5 + 0.8 * 2);
  EXPECT_FALSE(results.at(ResultQuantity::speed_along_axis).vector) << "would be compared as a vector";
  EXPECT_DOUBLE_EQ(numbers(results, ResultQuantity::speed_across_axis)[0], std::hypot(0.8 * 5 - 0.6 * 2, 1));
  EXPECT_DOUBLE_EQ(numbers(results, ResultQuantity::angular_velocity)[0], 5);
  EXPECT_EQ(numbers(results, ResultQuantity::angular_velocity_y), std::vector{3.0});
  EXPECT_EQ(numbers(results, ResultQuantity::arm_amplitudes), (std::vector{4.0, 6.0}));
  EXPECT_EQ(numbers(results, ResultQuantity::arm_phases), (std::vector{2.0, 0.5}));
  EXPECT_DOUBLE_EQ(numbers(results, ResultQuantity::sin_phase_shift)[0], std::sin(1.5));
  EXPECT_EQ(numbers(results, ResultQuantity::gap), std::vector{20.0 - 6 - 8});
  EXPECT_EQ(numbers(results, ResultQuantity::dipole), std::vector{-7.0});
}

// Noise in phase turns the arm's complex amplitude, whose mean is shorter: here 4 cos(0.1). The first cycle
// is a transient.
TEST(ResultsOfARun, AreMeansWithStandardErrorsIfItHasNoise) {
  RunRecord run = some_run();
  run.scene->fluid.thermal_energy = 0.1;
  run.thermal = ThermalRecord{
      .diffusion = {.lag = 100,
                    .effective_diffusion = MeanAndError<double>{.mean = 3, .standard_error = 0.3},
                    .rotational_diffusion = MeanAndError<double>{.mean = 0.05, .standard_error = 0.01},
                    .persistence_time = MeanAndError<double>{.mean = 10, .standard_error = 2}}};
  std::vector<CycleStatistics>& cycles = run.swimmers[0].cycles;
  cycles.push_back(cycles.back());
  cycles[1].arm_phases[0] = 2.1;
  cycles[2].arm_phases[0] = 1.9;
  cycles[2].velocity = Vec3(7, 2, 1);
  cycles[2].index = 3;
  const Results results = results_of(run, {});
  EXPECT_NEAR(numbers(results, ResultQuantity::arm_amplitudes)[0], 4 * std::cos(0.1), 1e-12);
  EXPECT_NEAR(numbers(results, ResultQuantity::arm_phases)[0], 2.0, 1e-12);
  const ResultValue& velocity = results.at(ResultQuantity::velocity);
  EXPECT_DOUBLE_EQ(velocity.numbers[0], (0.6 * 5 + 0.6 * 7) / 2 + 0.8 * 2);
  EXPECT_NEAR(velocity.error(0), 0.6, 1e-12);  // half the difference of two cycles
  EXPECT_FALSE(velocity.vector);
  EXPECT_TRUE(velocity.is_mean);
  EXPECT_NEAR(results.at(ResultQuantity::effective_diffusion).error(0), 0.3, 1e-12);
  EXPECT_GT(numbers(results, ResultQuantity::peclet)[0], 0);
  run.thermal->diffusion.lag = 40;  // too short to contain the motion along the axis
  EXPECT_FALSE(results_of(run, {}).contains(ResultQuantity::effective_diffusion));
}

TEST(ResultsOfARun, AreMeansOfTheChosenCycles) {
  const Results results = results_of(some_run(), {.number = 2});
  EXPECT_EQ(numbers(results, ResultQuantity::arm_amplitudes), (std::vector{3.0, 8.0}));
  EXPECT_EQ(numbers(results, ResultQuantity::power), std::vector{2.0});
  EXPECT_THROW(results_of(some_run(), {.number = 3}), InputError);
}

// A cycle without power leaves the mean unknown; a swimmer without arms has no stroke.
TEST(ResultsOfARun, LackWhatItsCyclesDoNotState) {
  RunRecord run = some_run();
  run.swimmers.front().cycles.front().power.reset();
  EXPECT_FALSE(results_of(run, {.number = 2}).contains(ResultQuantity::power));
  for (const auto arms :
       {&CycleStatistics::arm_amplitudes, &CycleStatistics::arm_phases, &CycleStatistics::arm_means})
    (run.swimmers.front().cycles.back().*arms).clear();
  for (const auto quantity : {ResultQuantity::arm_amplitudes, ResultQuantity::arm_phases,
                              ResultQuantity::sin_phase_shift, ResultQuantity::gap})
    EXPECT_FALSE(results_of(run, {}).contains(quantity)) << to_text(quantity);
}

// A run whose error by resolution is 0.05 % and whose model is expected to be wrong by 18 % states 18 %.
TEST(ResultsOfARun, StateTheExpectedError) {
  RunRecord run = some_run();
  SwimmerRecord& swimmer = run.swimmers.front();
  swimmer.uncertainty = SwimmerUncertainty{};
  swimmer.uncertainty->velocity = {.resolution = 5e-4, .wander = 0, .transient = 0.03, .total = 0.03};
  swimmer.uncertainty->arm_amplitudes.total = 1e-3;
  const auto uncertainties = [&](ResultQuantity quantity, RunUncertainty kind) {
    return results_of(run, swimmer, {}, "r.json", kind).at(quantity).uncertainties;
  };
  const auto stated = RunUncertainty::with_expected_error;
  EXPECT_EQ(uncertainties(ResultQuantity::velocity, stated), std::vector{0.03});
  EXPECT_EQ(uncertainties(ResultQuantity::speed_along_axis, stated), std::vector{0.03});
  run.expected_error = ErrorEstimate{.velocity = 0.18, .arm_amplitudes = {0.05, 0.06}};
  EXPECT_DOUBLE_EQ(uncertainties(ResultQuantity::velocity, stated)[0], std::hypot(0.18, 0.03));
  EXPECT_EQ(uncertainties(ResultQuantity::arm_amplitudes, stated), (std::vector{0.06, 0.06}));
  EXPECT_EQ(uncertainties(ResultQuantity::arm_amplitudes, RunUncertainty::of_cycle),
            (std::vector{1e-3, 1e-3}));
  EXPECT_TRUE(results_of(run, {.kind = CycleChoice::Kind::index, .number = run.swimmers[0].cycles[0].index})
                  .at(ResultQuantity::velocity)
                  .uncertainties.empty());
}

TEST(ResultsOfAPrediction, StateItsUncertainties) {
  Prediction prediction;
  prediction.velocity = -2;
  prediction.uncertainty = 0.25;
  prediction.stroke.amplitude = {3, 4};
  prediction.stroke.phase = {0, 1};
  prediction.sin_phase_shift = 0.5;
  prediction.stroke_uncertainty = StrokeUncertainty{{0.1, 0.2}, 0.05};
  const Layout scene = paper_single();
  const Results results = results_of(prediction, &scene, 0);
  EXPECT_DOUBLE_EQ(results.at(ResultQuantity::velocity).error(0), 0.5);
  EXPECT_DOUBLE_EQ(results.at(ResultQuantity::arm_amplitudes).error(1), 0.8);
  EXPECT_DOUBLE_EQ(results.at(ResultQuantity::sin_phase_shift).error(0), 0.05);
  EXPECT_EQ(numbers(results, ResultQuantity::gap), std::vector{20.0 - 4 - 8});
  EXPECT_FALSE(results_of(prediction, nullptr, 0).contains(ResultQuantity::gap));
  EXPECT_FALSE(results.contains(ResultQuantity::velocity_x));
  EXPECT_FALSE(results.contains(ResultQuantity::power));
}

// The speed across the axis of a swimmer that moves along it is zero to roundoff, not to its square root. If
// the drives turn the swimmer, its axis is not that of the scene.
TEST(ResultsOfAPrediction, HaveSpeedsAlongAndAcrossTheAxis) {
  Layout scene = paper_single();
  const Vec3 axis = Vec3(1, 2, 3).normalized();
  scene.swimmers[0].axis = axis;
  Prediction prediction;
  const auto across = [&](const Vec3& velocity, double along) {
    prediction.velocity_vector = velocity;
    prediction.velocity = along;
    const Results results = results_of(prediction, &scene, 0);
    EXPECT_EQ(numbers(results, ResultQuantity::speed_along_axis), std::vector{along});
    return numbers(results, ResultQuantity::speed_across_axis)[0];
  };
  EXPECT_LT(across(-0.7 * axis, -0.7), 1e-15);
  EXPECT_NEAR(across(-0.7 * axis + 0.2 * axis.unitOrthogonal(), -0.7), 0.2, 1e-15);
  prediction.settings.emplace_back("turn", 0.1);
  EXPECT_DOUBLE_EQ(across({0, 3, 5}, 3), 5);
}

TEST(UnitsOfResults, AreThoseOfTheDocument) {
  const Units units{false, {"um", 1e-6}, {"s", 1}, {"pg", 1e-15}};
  EXPECT_EQ(unit_of(ResultQuantity::power, units), "pg um²/s³");
  EXPECT_EQ(unit_of(ResultQuantity::angular_velocity_z, units), "rad/s");
  EXPECT_EQ(unit_of(ResultQuantity::gap, {}), "lattice units");
}

TEST(VerdictSchema, AcceptsEveryResult) {
  VerdictDocument verdict{.decided_by = "rpy-ode", .rows = {}, .cost = {}};
  for (const ResultQuantity quantity : all_values<ResultQuantity>) {
    ComparisonRow& row = verdict.rows.emplace_back();
    row.quantity = quantity;
    row.tolerance = 0.05;
  }
  EXPECT_NO_THROW(validate_json(verdict_to_json(verdict), "verdict", "v.json"));
}

}  // namespace
}  // namespace beadswim
