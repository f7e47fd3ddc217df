#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "beadswim/compare/cycle_statistics.hpp"
#include "beadswim/core/error.hpp"
#include "tolerances.hpp"

namespace beadswim {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double period = 2000;
constexpr std::array rest_lengths{20.0, 22.0};
constexpr std::array amplitudes{2.5, 3.6};
constexpr std::array phases{-2.2, 2.9};
constexpr double drift = 6e-5;                     // along the axis [cells/step]
constexpr double tolerance = 100 * roundoff(200);  // positions are of order 100

const Vec3 tilted_axis = Vec3(2, -1, 2) / 3;

/// Returns a swimmer that drifts along its axis while its mean bead position also oscillates once per period.
SwimmerSample swimmer_at(double time) {
  const double angle = 2 * pi * time / period;
  std::array<double, 2> arm{};
  for (int i = 0; i < 2; ++i) arm[i] = rest_lengths[i] + amplitudes[i] * std::cos(angle + phases[i]);
  const Vec3 middle = Vec3(60, 40, 40) + (drift * time + 0.3 * std::sin(angle)) * tilted_axis;
  return {time,
          {middle - arm[0] * tilted_axis, middle, middle + arm[1] * tilted_axis},
          Vec3(1e-6, 2e-6, 0) * (1 + std::cos(angle))};
}

std::vector<SwimmerSample> cycle(int n, double start) {
  std::vector<SwimmerSample> samples;
  for (int i = 0; i <= n; ++i) samples.push_back(swimmer_at(start + period * i / n));
  return samples;
}

// Would catch a velocity of bead 2 alone over less than a period, and a period of n-1 intervals.
TEST(CycleStatistics, VelocityIsTheDriftWhateverTheStroke) {
  for (const double start : {0.0, 0.37 * period, 3 * period}) {
    const CycleStatistics statistics = cycle_statistics(1, cycle(40, start), period);
    EXPECT_NEAR((statistics.velocity - drift * tilted_axis).norm(), 0, tolerance / period);
    EXPECT_NEAR(statistics.speed_along_axis, drift, tolerance / period);
    EXPECT_NEAR((statistics.axis - tilted_axis).norm(), 0, tolerance);
  }
}

// Before a swimmer is periodic its beads move by different amounts: would catch the velocity of bead 2.
TEST(CycleStatistics, VelocityIsThatOfTheMeanBeadPosition) {
  for (int bead = 0; bead < 3; ++bead) {
    std::vector<SwimmerSample> samples = cycle(40, 0);
    samples.back().bead_positions[bead] += Vec3(0, 3, 0);
    const Vec3 expected = drift * tilted_axis + Vec3(0, 1, 0) / period;
    EXPECT_NEAR((cycle_statistics(1, samples, period).velocity - expected).norm(), 0, tolerance / period);
  }
}

TEST(CycleStatistics, AxisPointsFromBead1ToBead3) {
  std::vector<SwimmerSample> samples = cycle(40, 0);
  for (SwimmerSample& sample : samples) std::swap(sample.bead_positions[0], sample.bead_positions[2]);
  const CycleStatistics statistics = cycle_statistics(1, samples, period);
  EXPECT_NEAR((statistics.axis + tilted_axis).norm(), 0, tolerance);
  EXPECT_NEAR(statistics.speed_along_axis, -drift, tolerance / period);
}

TEST(CycleStatistics, RecoversBothArmsStrokes) {
  const CycleStatistics statistics = cycle_statistics(3, cycle(40, 2 * period), period);
  EXPECT_EQ(statistics.index, 3);
  for (int arm = 0; arm < 2; ++arm) {
    EXPECT_NEAR(statistics.arm_means[arm], rest_lengths[arm], tolerance);
    EXPECT_NEAR(statistics.arm_amplitudes[arm], amplitudes[arm], tolerance);
    EXPECT_NEAR(statistics.arm_phases[arm], phases[arm], tolerance);
  }
}

// Would catch the last sample, one period after the first, in the fit: it would count that phase twice and
// let the second harmonic into the amplitude.
TEST(CycleStatistics, StrokeIsBlindToTheSecondHarmonic) {
  std::vector<SwimmerSample> samples = cycle(10, 0);
  for (SwimmerSample& sample : samples) {
    sample.bead_positions[2] += 0.8 * std::cos(4 * pi * sample.time / period) * tilted_axis;
  }
  const CycleStatistics statistics = cycle_statistics(1, samples, period);
  EXPECT_NEAR(statistics.arm_amplitudes[1], amplitudes[1], tolerance);
  EXPECT_NEAR(statistics.arm_phases[1], phases[1], tolerance);
}

TEST(CycleStatistics, MeanFlowIsItsTimeAverage) {
  const CycleStatistics statistics = cycle_statistics(1, cycle(40, 0), period);
  EXPECT_NEAR((statistics.mean_flow - Vec3(1e-6, 2e-6, 0)).norm(), 0, 1e-6 * roundoff(50));
}

TEST(CycleStatistics, RefusesSamplesThatAreNotOneCycle) {
  const std::vector<SwimmerSample> whole = cycle(40, 0);
  const std::span all(whole);
  EXPECT_THROW(cycle_statistics(1, all.first(40), period), InputError);
  EXPECT_THROW(cycle_statistics(1, all, 2 * period), InputError);
  EXPECT_THROW(cycle_statistics(1, {}, period), InputError);
  EXPECT_THROW(cycle_statistics(1, cycle(2, 0), period), InputError);
  std::vector<SwimmerSample> repeated = whole;
  repeated[5].time = repeated[4].time;
  EXPECT_THROW(cycle_statistics(1, repeated, period), InputError);
}

}  // namespace
}  // namespace beadswim
