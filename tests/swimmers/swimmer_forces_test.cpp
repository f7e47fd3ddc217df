#include "beadswim/swimmers/swimmer_forces.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

namespace beadswim {
namespace {

const BeadVectors bent{Vec3(-3, 0.4, 0.1), Vec3(0.2, -0.3, 0.5), Vec3(4, 0.8, -0.7)};

Vec3 sum(const BeadVectors& v) {
  return v[0] + v[1] + v[2];
}

Vec3 torque(const BeadVectors& at, const BeadVectors& force) {
  return at[0].cross(force[0]) + at[1].cross(force[1]) + at[2].cross(force[2]);
}

double angular_energy(double stiffness, const BeadVectors& at) {
  const Vec3 a = at[1] - at[0], b = at[2] - at[1];
  const double theta = std::atan2(a.cross(b).norm(), a.dot(b));
  return 0.5 * stiffness * theta * theta;
}

// Catches a wrong factor or sign: the force is minus the energy's gradient, taken here by differences.
TEST(AngularSpring, IsMinusTheGradientOfItsEnergy) {
  constexpr double stiffness = 7.0, h = 1e-5;
  const BeadVectors force = angular_spring_forces(stiffness, bent);
  for (int b = 0; b < 3; ++b) {
    for (int a = 0; a < 3; ++a) {
      BeadVectors ahead = bent, behind = bent;
      ahead[b][a] += h;
      behind[b][a] -= h;
      const double slope = (angular_energy(stiffness, ahead) - angular_energy(stiffness, behind)) / (2 * h);
      constexpr double truncation = 1e-9;  // h^2 and cancellation
      EXPECT_NEAR(force[b][a], -slope, truncation);
    }
  }
}

TEST(AngularSpring, RestsInLineAndIsFiniteWhenFolded) {
  const BeadVectors line{Vec3(-3, 0, 0), Vec3(0, 0, 0), Vec3(5, 0, 0)};
  const BeadVectors folded{Vec3(-3, 0, 0), Vec3(0, 0, 0), Vec3(-5, 0, 0)};
  for (const Vec3& f : angular_spring_forces(10, line)) EXPECT_EQ(f.norm(), 0);
  for (const Vec3& f : angular_spring_forces(10, folded)) EXPECT_TRUE(f.allFinite());
}

TEST(InnerForces, AreFreeOfForceAndTorque) {
  const BeadVectors velocity{Vec3(0.1, 0.2, -0.3), Vec3(-0.4, 0, 0.1), Vec3(0.2, 0.5, 0.3)};
  const std::array springs{Spring{2, 3.0, 0.7}, Spring{5, 4.5, 1.1}};
  const Driving body{{0.3, 0.8}, 1.0, 10, DrivingFrame::body};
  constexpr double roundoff = 1e-14;
  for (const BeadVectors& force : {spring_forces(springs, bent, velocity), angular_spring_forces(9, bent),
                                   driving_forces(body, 1.7, bent, Vec3::UnitX())}) {
    EXPECT_LT(sum(force).norm(), roundoff);
    EXPECT_LT(torque(bent, force).norm(), roundoff);
    EXPECT_GT(force[0].norm(), 0.01);
  }
}

// (2.1) in the frame of the laboratory: along x, whatever the swimmer's axis.
TEST(Driving, FollowsItsFrame) {
  const Driving lab{{0.2, 0.5}, std::numbers::pi / 2, 8, DrivingFrame::lab};
  Driving axis = lab;
  axis.frame = DrivingFrame::initial_axis;
  constexpr double roundoff = 1e-15;
  const BeadVectors f = driving_forces(lab, 1.0, bent, Vec3::UnitY());
  const double eighth = std::numbers::pi / 4;
  EXPECT_LT((f[0] - Vec3(0.2 * std::sin(eighth), 0, 0)).norm(), roundoff);
  EXPECT_LT((f[2] - Vec3(0.5 * std::cos(eighth), 0, 0)).norm(), roundoff);
  EXPECT_LT(sum(f).norm(), roundoff);
  const BeadVectors g = driving_forces(axis, 1.0, bent, Vec3::UnitY());
  EXPECT_LT((g[0] - Vec3(0, f[0][0], 0)).norm(), roundoff);
}

// An offset is the same driving earlier: by phi/(2 pi) of a period.
TEST(Driving, IsAheadByItsOffset) {
  const Driving driving{{0.2, 0.5}, 1.1, 8, DrivingFrame::lab};
  Driving ahead = driving;
  ahead.phase_offset = 2 * std::numbers::pi * 0.3;
  const BeadVectors now = driving_forces(ahead, 1.7, bent, Vec3::UnitX());
  const BeadVectors later = driving_forces(driving, 1.7 + 0.3 * 8, bent, Vec3::UnitX());
  for (int b = 0; b < 3; ++b) EXPECT_LT((now[b] - later[b]).norm(), 1e-15);
}

}  // namespace
}  // namespace beadswim
