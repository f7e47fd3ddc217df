#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "beadswim/compare/cycle_statistics.hpp"
#include "beadswim/core/error.hpp"
#include "beadswim/swimmers/swimmer_shape.hpp"
#include "beadswim/swimmers/three_bead_swimmer.hpp"
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

/// Returns cycle_statistics() of a three-bead swimmer with this driving period.
CycleStatistics statistics_of(int index, std::span<const SwimmerSample> samples, double driving_period) {
  ThreeBeadSwimmer swimmer;
  swimmer.springs = {Spring{1, rest_lengths[0], 0}, Spring{1, rest_lengths[1], 0}};
  swimmer.driving.period = driving_period;
  return cycle_statistics(index, samples, swimmer_type(swimmer), Eigen::Matrix3d::Identity());
}

std::vector<SwimmerSample> cycle(int n, double start) {
  std::vector<SwimmerSample> samples;
  for (int i = 0; i <= n; ++i) samples.push_back(swimmer_at(start + period * i / n));
  return samples;
}

// Would catch a velocity of bead 2 alone over less than a period, and a period of n-1 intervals.
TEST(CycleStatistics, VelocityIsTheDriftWhateverTheStroke) {
  for (const double start : {0.0, 0.37 * period, 3 * period}) {
    const CycleStatistics statistics = statistics_of(1, cycle(40, start), period);
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
    EXPECT_NEAR((statistics_of(1, samples, period).velocity - expected).norm(), 0, tolerance / period);
  }
}

TEST(CycleStatistics, AxisPointsFromBead1ToBead3) {
  std::vector<SwimmerSample> samples = cycle(40, 0);
  for (SwimmerSample& sample : samples) std::swap(sample.bead_positions[0], sample.bead_positions[2]);
  const CycleStatistics statistics = statistics_of(1, samples, period);
  EXPECT_NEAR((statistics.axis + tilted_axis).norm(), 0, tolerance);
  EXPECT_NEAR(statistics.speed_along_axis, -drift, tolerance / period);
}

TEST(CycleStatistics, RecoversBothArmsStrokes) {
  const CycleStatistics statistics = statistics_of(3, cycle(40, 2 * period), period);
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
  const CycleStatistics statistics = statistics_of(1, samples, period);
  EXPECT_NEAR(statistics.arm_amplitudes[1], amplitudes[1], tolerance);
  EXPECT_NEAR(statistics.arm_phases[1], phases[1], tolerance);
}

TEST(CycleStatistics, MeanFlowIsItsTimeAverage) {
  const CycleStatistics statistics = statistics_of(1, cycle(40, 0), period);
  EXPECT_NEAR((statistics.mean_flow - Vec3(1e-6, 2e-6, 0)).norm(), 0, 1e-6 * roundoff(50));
}

/// Returns a triangle with a tail: four arms of a graph that is no chain.
SwimmerType tailed_triangle() {
  SwimmerType type;
  for (const Vec3& at : {Vec3(-8, -4, 0), Vec3(8, -4, 0), Vec3(0, 9, 0), Vec3(0, 30, 0)})
    type.beads.push_back({{.radius = 4, .density = 1}, at});
  for (const std::array<int, 2>& beads : {std::array{0, 1}, {1, 2}, {2, 0}, {2, 3}})
    type.bonds.push_back({{1, 16, 0}, beads});
  type.driving.period = period;
  return type;
}

/// Rotation by `angle` per period about an axis through a point at the distance `offset` from the origin of
/// the type, displacement along this axis, and an oscillation of the mean bead position, all along the frame
/// of the type at time 0.
struct Screw {
  double angle = 0;
  Vec3 offset = Vec3(5, 3, -2), oscillation = Vec3(-1, 2, 1);
  Eigen::Matrix3d start = Eigen::AngleAxisd(2.0, Vec3(1, 2, 2) / 3).toRotationMatrix();
  Vec3 flow = Vec3::Zero();  ///< [cells/step]

  Eigen::Matrix3d rotation(double cycles) const {
    return Eigen::AngleAxisd(angle * cycles, tilted_axis).toRotationMatrix();
  }
  Eigen::Matrix3d orientation(double cycles) const { return rotation(cycles) * start; }
  std::vector<SwimmerSample> samples(const SwimmerType& type, double first_cycle) const {
    std::vector<SwimmerSample> list;
    for (int n = 0; n <= 40; ++n) {
      const double cycles = first_cycle + n / 40.0, time = period * cycles;
      const Vec3 place = Vec3(50, 60, 70) + drift * time * tilted_axis + time * flow +
                         rotation(cycles) * (offset + std::sin(2 * pi * cycles + 0.4) * oscillation);
      list.push_back({time, rest_positions(type, place, orientation(cycles))});
    }
    return list;
  }
};

constexpr std::array angles{1e-9, 0.16, 2.0, pi, -5.0, 2 * pi, 6.5, -24.0};  // [rad], per period

TEST(CycleStatistics, RotationIncludesWholeTurns) {
  SwimmerType rod = tailed_triangle();
  rod.bonds = {rod.bonds[0]};
  rod.beads.resize(2);
  for (const double angle : angles) {
    const Screw screw{.angle = angle};
    const SwimmerType type = tailed_triangle();
    const CycleStatistics statistics = cycle_statistics(1, screw.samples(type, 0), type, screw.start);
    EXPECT_NEAR((*statistics.angular_velocity * period - angle * tilted_axis).norm(), 0, tolerance) << angle;
    const auto& [w, x, y, z] = *statistics.orientation;
    EXPECT_NEAR((Eigen::Quaterniond(w, x, y, z).toRotationMatrix() - screw.orientation(1)).norm(), 0,
                tolerance);
    EXPECT_EQ(statistics.arm_means.size(), 4u);
    EXPECT_NEAR(statistics.arm_means[3], 21, tolerance);
    // A rod across the axis of the rotation; its rotation about itself is not defined. After exactly half a
    // turn neither is the shortest turn between its directions.
    if (angle == pi) continue;
    const Screw across{.angle = angle, .start = shortest_turn(Vec3(2, 2, -1) / 3)};
    const CycleStatistics of_rod = cycle_statistics(1, across.samples(rod, 0), rod, across.start);
    EXPECT_NEAR((*of_rod.angular_velocity * period - angle * tilted_axis).norm(), 0, tolerance) << angle;
  }
}

// Would catch the displacement between the ends of the cycle, which depends on the phase of the oscillation
// there, a mean of it in the frame of the box, and a flow that is turned with the swimmer.
TEST(CycleStatistics, VelocityOfAScrewMotionDoesNotDependOnTheStartOfTheCycle) {
  const SwimmerType type = tailed_triangle();
  for (const double angle : angles)
    for (const Vec3& flow : {Vec3(0, 0, 0), Vec3(0.1, -0.2, 0.3)})
      for (const double first : {0.0, 0.3, 7.8}) {
        const Screw screw{.angle = angle, .flow = flow};
        const CycleStatistics statistics =
            cycle_statistics(1, screw.samples(type, first), type, screw.start, {.velocity = flow});
        const Vec3 mean =
            screw.offset + screw.start * Vec3(0, 7.75, 0);  // mean bead position without oscillation
        const Vec3 turned = screw.rotation(first + 1) * mean - screw.rotation(first) * mean;
        EXPECT_NEAR((statistics.velocity - turned / period - drift * tilted_axis - flow).norm(), 0,
                    10 * tolerance / period)
            << angle << " " << first;
        EXPECT_NEAR((statistics.axis - screw.orientation(first + 0.5).col(0)).norm(), 0, tolerance);
      }
}

// Forces along directions of the box do not turn with the swimmer, and neither does its oscillation.
TEST(CycleStatistics, VelocityUnderForcesAlongTheBoxIsTheDisplacement) {
  SwimmerType type = tailed_triangle();
  type.driving.forces.push_back({.bead = 0, .direction = Vec3::UnitX()});
  const Screw screw{.angle = 2};
  const std::vector<SwimmerSample> samples = screw.samples(type, 0);
  Vec3 displacement = Vec3::Zero();
  for (int b = 0; b < 4; ++b)
    displacement += (samples.back().bead_positions[b] - samples.front().bead_positions[b]) / 4;
  const Vec3 velocity = cycle_statistics(1, samples, type, screw.start).velocity;
  EXPECT_NEAR((velocity - displacement / period).norm(), 0, tolerance / period);
}

TEST(CycleStatistics, RefusesSamplesThatAreNotOneCycle) {
  const std::vector<SwimmerSample> whole = cycle(40, 0);
  const std::span all(whole);
  EXPECT_THROW(statistics_of(1, all.first(40), period), InputError);
  EXPECT_THROW(statistics_of(1, all, 2 * period), InputError);
  EXPECT_THROW(statistics_of(1, {}, period), InputError);
  EXPECT_THROW(statistics_of(1, cycle(2, 0), period), InputError);
  std::vector<SwimmerSample> repeated = whole;
  repeated[5].time = repeated[4].time;
  EXPECT_THROW(statistics_of(1, repeated, period), InputError);
}

}  // namespace
}  // namespace beadswim
