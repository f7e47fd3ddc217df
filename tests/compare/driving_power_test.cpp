#include "beadswim/compare/driving_power.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>
#include <vector>

#include "beadswim/swimmers/swimmer_forces.hpp"
#include "beadswim/swimmers/three_bead_swimmer.hpp"

namespace beadswim {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double period = 2000;

/// Returns the beads of a swimmer that drifts, turns by `turn` per period and bends. Its arm lengths have two
/// harmonics.
SwimmerSample swimmer_at(double time, double turn) {
  const double angle = 2 * pi * time / period;
  const Vec3 first = Eigen::AngleAxisd(turn * time / period, Vec3(0, 0.6, 0.8)) * Vec3(2, -1, 2) / 3;
  const Vec3 second = Eigen::AngleAxisd(0.2 * std::sin(angle), Vec3(0, 0, 1)) * first;
  const double arm_1 = 20 + 2.5 * std::cos(angle - 2.2) + 0.4 * std::cos(2 * angle);
  const double arm_2 = 22 + 3.6 * std::cos(angle + 2.9) + 0.3 * std::sin(2 * angle);
  const Vec3 middle = Vec3(60, 40, 40) + (0.02 * time + 0.3 * std::sin(angle)) * first;
  return {time, {middle - arm_1 * first, middle, middle + arm_2 * second}};
}

std::vector<SwimmerSample> cycle(int n, double turn) {
  std::vector<SwimmerSample> samples;
  for (int i = 0; i <= n; ++i) samples.push_back(swimmer_at(0.37 * period + period * i / n, turn));
  return samples;
}

/// Returns the work of driving_forces() along the motion, divided by the period, by the midpoint rule with n
/// steps.
double work_over_period(const ThreeBeadDriving& driving, const Vec3& initial_axis, double turn, int n) {
  const std::vector<SwimmerSample> ends = cycle(n, turn);
  const SwimmerType type = swimmer_type({.driving = driving});
  double work = 0;
  for (int i = 0; i < n; ++i) {
    const SwimmerSample middle = swimmer_at((ends[i].time + ends[i + 1].time) / 2, turn);
    BeadVectors position(3, 3);
    for (int b = 0; b < 3; ++b) position.col(b) = middle.bead_positions[b];
    const BeadVectors force = driving_forces(type, middle.time, position, shortest_turn(initial_axis));
    for (int b = 0; b < 3; ++b)
      work += force.col(b).dot(ends[i + 1].bead_positions[b] - ends[i].bead_positions[b]);
  }
  return work / period;
}

TEST(DrivingPower, IsTheWorkOfTheDrivingForces) {
  constexpr int steps = 20000;
  const double discretisation = 10 * std::pow(2 * pi / steps, 2);
  ThreeBeadDriving driving{.amplitude = {0.2, 0.35}, .phase = 1.1, .period = period, .phase_offset = 0.4};
  const Vec3 initial_axis = Vec3(1, 2, -2) / 3;
  for (const DrivingFrame frame : all_values<DrivingFrame>) {
    driving.frame = frame;
    for (const int samples : {8, 40}) {
      const double power = driving_power(driving, initial_axis, cycle(samples, 0));
      EXPECT_NEAR(power / work_over_period(driving, initial_axis, 0, steps), 1, discretisation)
          << to_text(frame);
    }
  }
}

// Forces along the arms turn with the swimmer: the power does not change.
TEST(DrivingPower, OfForcesAlongTheArmsDoesNotDependOnTheTurningOfTheSwimmer) {
  const ThreeBeadDriving driving{
      .amplitude = {0.2, 0.35}, .phase = 1.1, .period = period, .frame = DrivingFrame::body};
  const double straight = driving_power(driving, Vec3::UnitX(), cycle(40, 0));
  EXPECT_NEAR(driving_power(driving, Vec3::UnitX(), cycle(40, 0.5)) / straight, 1, 1e-12);
  EXPECT_NEAR(straight / work_over_period(driving, Vec3::UnitX(), 0.5, 20000), 1, 1e-6);
}

}  // namespace
}  // namespace beadswim
