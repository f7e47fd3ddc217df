#include "beadswim/swimmers/swimmer_forces.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <random>

#include "bead_vectors.hpp"
#include "beadswim/swimmers/three_bead_swimmer.hpp"

namespace beadswim {
namespace {

const BeadVectors bent = columns({Vec3(-3, 0.4, 0.1), Vec3(0.2, -0.3, 0.5), Vec3(4, 0.8, -0.7)});

Vec3 torque(const BeadVectors& at, const BeadVectors& force) {
  Vec3 sum = Vec3::Zero();
  for (int b = 0; b < at.cols(); ++b) sum += Vec3(at.col(b)).cross(Vec3(force.col(b)));
  return sum;
}

double bond_energy(const SwimmerType& type, double time, const BeadVectors& at) {
  double energy = 0;
  for (std::size_t k = 0; k < type.bonds.size(); ++k) {
    const auto [i, j] = type.bonds[k].beads;
    const double extension = (at.col(j) - at.col(i)).norm() - rest_length(type, k, time);
    energy += 0.5 * type.bonds[k].stiffness * extension * extension;
  }
  return energy;
}

double angular_energy(const SwimmerType& type, double time, const BeadVectors& at) {
  double energy = 0;
  for (std::size_t k = 0; k < type.angles.size(); ++k) {
    const auto [i, j, l] = type.angles[k].beads;
    const Vec3 a = at.col(j) - at.col(i), b = at.col(l) - at.col(j);
    const double bend = std::atan2(a.cross(b).norm(), a.dot(b)) - rest_angle(type, k, time);
    energy += 0.5 * type.angles[k].stiffness * bend * bend;
  }
  return energy;
}

/// Checks that the force is minus the gradient of the energy, taken by central differences.
void expect_minus_gradient(const BeadVectors& force, const BeadVectors& at,
                           const std::function<double(const BeadVectors&)>& energy) {
  constexpr double h = 1e-5;
  for (int b = 0; b < at.cols(); ++b) {
    for (int a = 0; a < 3; ++a) {
      BeadVectors ahead = at, behind = at;
      ahead(a, b) += h;
      behind(a, b) -= h;
      const double slope = (energy(ahead) - energy(behind)) / (2 * h);
      constexpr double truncation = 1e-9;  // h^2 and cancellation
      EXPECT_NEAR(force(a, b), -slope, truncation) << "bead " << b + 1 << ", axis " << a;
    }
  }
}

/// Returns a type of three beads with this angular stiffness.
SwimmerType with_angular_stiffness(double stiffness) {
  return swimmer_type({.angular_stiffness = stiffness, .driving = {.period = 1}});
}

// Catches a wrong factor or sign.
TEST(AngularSpring, IsMinusTheGradientOfItsEnergy) {
  const SwimmerType type = with_angular_stiffness(7);
  expect_minus_gradient(angle_forces(type, 0, bent), bent,
                        [&](const BeadVectors& at) { return angular_energy(type, 0, at); });
}

TEST(AngularSpring, RestsInLineAndIsFiniteWhenFolded) {
  const BeadVectors line = columns({Vec3(-3, 0, 0), Vec3(0, 0, 0), Vec3(5, 0, 0)});
  const BeadVectors folded = columns({Vec3(-3, 0, 0), Vec3(0, 0, 0), Vec3(-5, 0, 0)});
  SwimmerType type = with_angular_stiffness(10);
  EXPECT_EQ(angle_forces(type, 0, line).norm(), 0);
  EXPECT_TRUE(angle_forces(type, 0, folded).allFinite());
  type.angles[0].rest = 0.5;  // no direction to bend to
  EXPECT_EQ(angle_forces(type, 0, line).norm(), 0);
  EXPECT_EQ(angle_forces(type, 0, folded).norm(), 0);
}

TEST(InnerForces, AreFreeOfForceAndTorque) {
  const BeadVectors velocity = columns({Vec3(0.1, 0.2, -0.3), Vec3(-0.4, 0, 0.1), Vec3(0.2, 0.5, 0.3)});
  const SwimmerType type = swimmer_type({.springs = {Spring{2, 3.0, 0.7}, Spring{5, 4.5, 1.1}},
                                         .angular_stiffness = 9,
                                         .driving = {{0.3, 0.8}, 1.0, 10, DrivingFrame::body}});
  constexpr double roundoff = 1e-14;
  for (const BeadVectors& force : {bond_forces(type, 0, bent, velocity), angle_forces(type, 0, bent),
                                   driving_forces(type, 1.7, bent, Eigen::Matrix3d::Identity())}) {
    EXPECT_LT(force.rowwise().sum().norm(), roundoff);
    EXPECT_LT(torque(bent, force).norm(), roundoff);
    EXPECT_GT(force.col(0).norm(), 0.01);
  }
}

// (2.1) in the frame of the laboratory: along x, whatever the swimmer's axis.
TEST(Driving, FollowsItsFrame) {
  ThreeBeadDriving driving{{0.2, 0.5}, std::numbers::pi / 2, 8, DrivingFrame::lab};
  const Eigen::Matrix3d along_y = shortest_turn(Vec3::UnitY());
  constexpr double roundoff = 1e-15;
  const BeadVectors f = driving_forces(swimmer_type({.driving = driving}), 1.0, bent, along_y);
  const double eighth = std::numbers::pi / 4;
  EXPECT_LT((f.col(0) - Vec3(0.2 * std::sin(eighth), 0, 0)).norm(), roundoff);
  EXPECT_LT((f.col(2) - Vec3(0.5 * std::cos(eighth), 0, 0)).norm(), roundoff);
  EXPECT_LT(f.rowwise().sum().norm(), roundoff);
  driving.frame = DrivingFrame::initial_axis;
  const BeadVectors g = driving_forces(swimmer_type({.driving = driving}), 1.0, bent, along_y);
  EXPECT_LT((g.col(0) - Vec3(0, f(0, 0), 0)).norm(), roundoff);
}

// An offset is the same driving earlier: by phi/(2 pi) of a period.
TEST(Driving, IsAheadByItsOffset) {
  const SwimmerType type = swimmer_type({.driving = {{0.2, 0.5}, 1.1, 8, DrivingFrame::lab}});
  SwimmerType ahead = type;
  ahead.driving.phase_offset = 2 * std::numbers::pi * 0.3;
  const BeadVectors now = driving_forces(ahead, 1.7, bent, Eigen::Matrix3d::Identity());
  const BeadVectors later = driving_forces(type, 1.7 + 0.3 * 8, bent, Eigen::Matrix3d::Identity());
  for (int b = 0; b < 3; ++b) EXPECT_LT((now.col(b) - later.col(b)).norm(), 1e-15);
}

/// Returns five beads: four in a loop of four bonds, and a fifth at its last bead. Two bonds, and one of the
/// two bent angles, are driven.
SwimmerType loop_with_tail() {
  SwimmerType type;
  for (const Vec3& at :
       {Vec3(0, 0, 0), Vec3(4, 0.3, -0.5), Vec3(3.6, 3.8, 0.4), Vec3(-0.4, 4.1, 1.2), Vec3(-3.5, 6.2, 0.1)})
    type.beads.push_back({{.radius = 1, .density = 1}, at});
  type.bonds = {{{2, 3.5, 0.7}, {0, 1}},
                {{5, 3.9, 1.1}, {1, 2}},
                {{3, 4.2, 0}, {2, 3}},
                {{4, 4.4, 0.3}, {3, 0}},
                {{6, 3.6, 0.5}, {3, 4}}};
  type.angles = {{.beads = {0, 1, 2}, .stiffness = 7, .rest = 1.2},
                 {.beads = {2, 3, 4}, .stiffness = 5, .rest = 0.6}};
  const std::vector<Harmonic> stroke{{.amplitude = 0.6, .phase = 0.4},
                                     {.amplitude = 0.2, .phase = 1, .multiple = 2}};
  type.driving = {.period = 8,
                  .phase_offset = 0.7,
                  .bonds = {{.bond = 1, .quantity = BondQuantity::rest_length, .harmonics = stroke},
                            {.bond = 4, .quantity = BondQuantity::tension, .harmonics = stroke},
                            {.bond = 3, .harmonics = {{.amplitude = 0.3, .phase = 2, .multiple = 3}}}},
                  .angles = {{.angle = 0, .harmonics = stroke}}};
  return type;
}

/// Returns the beads of a type, each displaced from its place at rest.
BeadVectors displaced_beads(const SwimmerType& type, std::mt19937& random) {
  BeadVectors at = columns(rest_positions(type, Vec3(1, 2, 3), random_rotation(random)));
  for (auto bead : at.colwise()) bead += 0.2 * random_vector(random);
  return at;
}

// Would catch a bead, a rest length or a rest angle of a bond or an angle that is taken from another.
TEST(GraphOfBeads, HasTheForcesOfItsEnergy) {
  std::mt19937 random(1);
  const SwimmerType type = loop_with_tail();
  for (const double time : {0.0, 1.3, 5.7}) {
    const BeadVectors at = displaced_beads(type, random);
    const BeadVectors still = BeadVectors::Zero(3, 5);
    expect_minus_gradient(bond_forces(type, time, at, still), at,
                          [&](const BeadVectors& x) { return bond_energy(type, time, x); });
    expect_minus_gradient(angle_forces(type, time, at), at,
                          [&](const BeadVectors& x) { return angular_energy(type, time, x); });
  }
}

TEST(GraphOfBeads, HasNoTotalForceOrTorqueFromWithin) {
  std::mt19937 random(2);
  const SwimmerType type = loop_with_tail();
  for (const double time : {0.0, 1.3, 5.7}) {
    const BeadVectors at = displaced_beads(type, random);
    BeadVectors velocity(3, 5);
    for (auto bead : velocity.colwise()) bead = random_vector(random);
    constexpr double roundoff = 1e-13;
    for (const BeadVectors& force : {bond_forces(type, time, at, velocity), angle_forces(type, time, at),
                                     driving_forces(type, time, at, random_rotation(random))}) {
      EXPECT_LT(force.rowwise().sum().norm(), roundoff);
      EXPECT_LT(torque(at, force).norm(), roundoff);
      EXPECT_GT(force.col(3).norm(), 0.01);
    }
  }
}

/// Returns A sin(n (w t + phi) + phase), where w and phi are those of the driving.
double written_out(double amplitude, int n, double phase, const Driving& driving, double time) {
  return amplitude *
         std::sin(n * (2 * std::numbers::pi / driving.period * time + driving.phase_offset) + phase);
}

TEST(Drives, AreSumsOfHarmonics) {
  SwimmerType type = loop_with_tail();
  const Driving& driving = type.driving;
  type.driving.forces = {{.bead = 2, .harmonics = {{.amplitude = 0.8, .phase = 0.3, .multiple = 2}}}};
  std::mt19937 random(3);
  const BeadVectors at = displaced_beads(type, random);
  constexpr double roundoff = 1e-14;
  for (const double time : {0.0, 0.9, 3.3, 21.2}) {
    const double stroke = written_out(0.6, 1, 0.4, driving, time) + written_out(0.2, 2, 1, driving, time);
    EXPECT_NEAR(rest_length(type, 1, time), 3.9 + stroke, roundoff);
    EXPECT_NEAR(rest_angle(type, 0, time), 1.2 + stroke, roundoff);
    EXPECT_EQ(rest_length(type, 4, time), 3.6);
    EXPECT_EQ(rest_angle(type, 1, time), 0.6);
    const BeadVectors force = driving_forces(type, time, at, random_rotation(random));
    // A positive tension pulls bead 5 towards bead 4.
    EXPECT_LT((force.col(4) - stroke * (at.col(3) - at.col(4)).normalized()).norm(), roundoff);
    EXPECT_LT((force.col(2) - written_out(0.8, 2, 0.3, driving, time) * Vec3::UnitX()).norm(), roundoff);
  }
}

TEST(Drives, TurnWithTheirFrame) {
  std::mt19937 random(4);
  SwimmerType type = loop_with_tail();
  const Vec3 direction = random_vector(random).normalized();
  type.driving = {.period = 8,
                  .forces = {{.bead = 2, .direction = direction, .constant = 0.3}},
                  .net_force = NetForce::allowed};
  const Eigen::Matrix3d start = random_rotation(random), now = random_rotation(random);
  const BeadVectors at = columns(rest_positions(type, Vec3(1, 2, 3), now));
  const auto force = [&](DrivingFrame frame) {
    type.driving.frame = frame;
    return driving_forces(type, 5, at, start);
  };
  constexpr double roundoff = 1e-15,
                   fit = 1e-11;  // the fit is drawn a little to the orientation at the start
  EXPECT_LT((force(DrivingFrame::lab).col(2) - 0.3 * direction).norm(), roundoff);
  EXPECT_LT((force(DrivingFrame::initial_axis).col(2) - 0.3 * start * direction).norm(), roundoff);
  EXPECT_LT((force(DrivingFrame::body).col(2) - 0.3 * now * direction).norm(), fit);
  EXPECT_NEAR(force(DrivingFrame::body).norm(), 0.3, fit);  // on bead 3 alone
}

/// Returns the largest force by the drives of forces and bonds on a bead at rest, at 360 times of a period.
double largest_of_period(const SwimmerType& type) {
  const Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();
  const BeadVectors at = columns(rest_positions(type, Vec3::Zero(), turn)), still = 0 * at;
  SwimmerType undriven = type;
  undriven.driving.bonds.clear();
  double largest = 0;
  for (int n = 0; n < 360; ++n) {
    const double time = type.driving.period * n / 360;
    const BeadVectors force = driving_forces(type, time, at, turn) + bond_forces(type, time, at, still) -
                              bond_forces(undriven, time, at, still);
    largest = std::max(largest, force.colwise().norm().maxCoeff());
  }
  return largest;
}

TEST(LargestDrivingForce, BoundsTheForcesOfAPeriod) {
  SwimmerType type = loop_with_tail();
  EXPECT_LE(largest_of_period(type), largest_driving_force(type));
  EXPECT_LE(largest_driving_force(type), 2 * largest_of_period(type));
  // One harmonic has its peak at one of the 360 times.
  const Harmonic one{.amplitude = -0.5, .phase = std::numbers::pi / 3};
  type.driving = {.period = 8, .forces = {{.bead = 2, .constant = 0.3, .harmonics = {one}}}};
  EXPECT_NEAR(largest_driving_force(type), largest_of_period(type), 1e-9);
  type.driving = {.period = 8, .bonds = {{.bond = 4, .harmonics = {one}}}};
  EXPECT_NEAR(largest_driving_force(type), largest_of_period(type), 1e-9);
  type.driving = {.period = 8, .bonds = {{.quantity = BondQuantity::rest_length, .harmonics = {one}}}};
  EXPECT_NEAR(largest_driving_force(type), largest_of_period(type), 1e-9);
}

}  // namespace
}  // namespace beadswim
