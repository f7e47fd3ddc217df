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
  const Vec3 second = Eigen::AngleAxisd(0.6 + 0.2 * std::sin(angle), Vec3(0, 0, 1)) * first;
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

/// Returns the energy of bonds and angular springs at `time`. (It needs no damping and no angle 0.)
double elastic_energy(const SwimmerType& type, double time, const SwimmerSample& sample) {
  double energy = 0;
  for (std::size_t k = 0; k < type.bonds.size(); ++k)
    energy += type.bonds[k].stiffness / 2 *
              std::pow(bond_vector(sample, type.bonds[k]).norm() - rest_length(type, k, time), 2);
  for (std::size_t k = 0; k < type.angles.size(); ++k)
    energy += type.angles[k].stiffness / 2 *
              std::pow(angle_between(type.angles[k], sample.bead_positions) - rest_angle(type, k, time), 2);
  return energy;
}

/// Returns the work of the drives along the motion, divided by the period, by the midpoint rule with n steps:
/// that of driving_forces() on the beads, and that of driven rest lengths and angles, the change of the
/// elastic energy at fixed beads.
double work_over_period(const SwimmerType& type, const Vec3& initial_axis, double turn, int n) {
  const std::vector<SwimmerSample> ends = cycle(n, turn);
  double work = 0;
  for (int i = 0; i < n; ++i) {
    const SwimmerSample middle = swimmer_at((ends[i].time + ends[i + 1].time) / 2, turn);
    const BeadVectors force = driving_forces(type, middle.time, columns_of_beads(middle.bead_positions),
                                             shortest_turn(initial_axis));
    for (int b = 0; b < 3; ++b)
      work += force.col(b).dot(ends[i + 1].bead_positions[b] - ends[i].bead_positions[b]);
    work += elastic_energy(type, ends[i + 1].time, middle) - elastic_energy(type, ends[i].time, middle);
  }
  return work / period;
}

constexpr int steps = 20000;
const double discretisation = 10 * std::pow(2 * pi / steps, 2);

TEST(DrivingPower, IsTheWorkOfTheDrivingForces) {
  ThreeBeadDriving driving{.amplitude = {0.2, 0.35}, .phase = 1.1, .period = period, .phase_offset = 0.4};
  const Vec3 initial_axis = Vec3(1, 2, -2) / 3;
  for (const DrivingFrame frame : all_values<DrivingFrame>) {
    driving.frame = frame;
    const SwimmerType type = swimmer_type({.driving = driving});
    for (const int samples : {8, 40}) {
      const double power = driving_power(type, shortest_turn(initial_axis), cycle(samples, 0)).value();
      EXPECT_NEAR(power / work_over_period(type, initial_axis, 0, steps), 1, discretisation)
          << to_text(frame);
    }
  }
}

// Forces along the arms turn with the swimmer: the power does not change.
TEST(DrivingPower, OfForcesAlongTheArmsDoesNotDependOnTheTurningOfTheSwimmer) {
  const SwimmerType type = swimmer_type(
      {.driving = {.amplitude = {0.2, 0.35}, .phase = 1.1, .period = period, .frame = DrivingFrame::body}});
  const Eigen::Matrix3d along_x = Eigen::Matrix3d::Identity();
  const double straight = driving_power(type, along_x, cycle(40, 0)).value();
  EXPECT_NEAR(driving_power(type, along_x, cycle(40, 0.5)).value() / straight, 1, 1e-12);
  EXPECT_NEAR(straight / work_over_period(type, Vec3::UnitX(), 0.5, steps), 1, 1e-6);
}

/// Returns a type with springs, and one drive.
SwimmerType driven(const Driving& driving) {
  ThreeBeadSwimmer swimmer;
  swimmer.springs = {Spring{0.03, 20, 0}, Spring{0.05, 22, 0}};
  swimmer.angular_stiffness = 9;
  SwimmerType type = swimmer_type(swimmer);
  type.angles[0].rest = 0.3;
  type.driving = driving;
  return type;
}

// Each kind of drive alone, with two harmonics and a phase offset, and a towing force.
TEST(DrivingPower, IsTheWorkOfEveryKindOfDrive) {
  const std::vector<Harmonic> harmonics{{.amplitude = 0.3, .phase = 0.5},
                                        {.amplitude = 0.2, .phase = -1, .multiple = 2}};
  const Driving none{.period = period, .phase_offset = 0.4, .frame = DrivingFrame::initial_axis};
  std::vector<Driving> drivings(5, none);
  drivings[0].forces = {{.bead = 2, .direction = Vec3(2, 1, 2) / 3, .constant = 0.1, .harmonics = harmonics}};
  drivings[1].bonds = {{.bond = 1, .quantity = BondQuantity::tension, .harmonics = harmonics}};
  drivings[2].bonds = {{.bond = 0, .quantity = BondQuantity::rest_length, .harmonics = harmonics}};
  drivings[3].angles = {{.angle = 0, .harmonics = harmonics}};
  const Vec3 initial_axis = Vec3(1, 2, -2) / 3;
  drivings[4] = drivings[0];
  drivings[4].frame = DrivingFrame::body;
  for (const Driving& driving : drivings) {
    const SwimmerType type = driven(driving);
    const double work = work_over_period(type, initial_axis, 0, steps);
    EXPECT_GT(std::abs(work), 1e-8);
    EXPECT_NEAR(driving_power(type, shortest_turn(initial_axis), cycle(40, 0)).value() / work, 1, 1e-5);
  }
}

}  // namespace
}  // namespace beadswim
