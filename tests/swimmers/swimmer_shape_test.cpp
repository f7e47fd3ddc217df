#include "beadswim/swimmers/swimmer_shape.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include "bead_vectors.hpp"

namespace beadswim {
namespace {

double largest_entry(const Eigen::Matrix3d& matrix) {
  return matrix.cwiseAbs().maxCoeff();
}

void expect_rotation(const Eigen::Matrix3d& turn, double roundoff) {
  EXPECT_LT(largest_entry(turn.transpose() * turn - Eigen::Matrix3d::Identity()), roundoff);
  EXPECT_NEAR(turn.determinant(), 1, roundoff);
}

/// Returns the turn of x by theta about an axis in the y-z plane.
Vec3 axis_at(double theta, double azimuth) {
  return {std::cos(theta), std::sin(theta) * std::cos(azimuth), std::sin(theta) * std::sin(azimuth)};
}

// Catches a denominator that vanishes near -x. Seed 1.
TEST(ShortestTurn, IsARotationOfXOntoTheAxis) {
  std::mt19937 random(1);
  std::vector<Vec3> axes{Vec3::UnitX(), -Vec3::UnitX(), Vec3::UnitY(), -Vec3::UnitZ()};
  for (int trial = 0; trial < 1000; ++trial) axes.push_back(random_vector(random).normalized());
  for (double off = 0.1; off > 1e-12; off /= 3) axes.push_back(axis_at(std::numbers::pi - off, 0.7));
  for (const Vec3& axis : axes) {
    SCOPED_TRACE(testing::Message() << axis.transpose());
    const Eigen::Matrix3d turn = shortest_turn(axis);
    constexpr double roundoff = 1e-15;
    expect_rotation(turn, roundoff);
    EXPECT_EQ(turn.col(0), axis);
    // The shortest turn leaves x cross axis, about which it turns, in place.
    const Vec3 fixed = Vec3::UnitX().cross(axis);
    EXPECT_LT((turn * fixed - fixed).norm(), roundoff);
  }
}

TEST(ShortestTurn, TurnsAboutZForMinusX) {
  EXPECT_EQ(shortest_turn(-Vec3::UnitX()), Eigen::Matrix3d(Eigen::Vector3d(-1, -1, 1).asDiagonal()));
  EXPECT_EQ(shortest_turn(Vec3::UnitX()), Eigen::Matrix3d::Identity());
}

SwimmerType with_beads_at(const std::vector<Vec3>& places) {
  SwimmerType type;
  for (const Vec3& at : places) type.beads.push_back({{.radius = 1, .density = 1}, at});
  return type;
}

TEST(RestPositions, TurnAndMoveTheBeads) {
  std::mt19937 random(2);
  const std::vector<Vec3> places{Vec3(-3, 0, 0), Vec3(1, 2, 0), Vec3(0, 0, 4)};
  const Vec3 origin = random_vector(random);
  const Eigen::Matrix3d turn = random_rotation(random);
  const std::vector<Vec3> beads = rest_positions(with_beads_at(places), origin, turn);
  constexpr double roundoff = 1e-14;
  for (std::size_t b = 0; b < places.size(); ++b)
    EXPECT_LT((beads[b] - origin - turn * places[b]).norm(), roundoff);
}

/// Returns fitted_orientation() of beads that are turned and moved without deformation.
Eigen::Matrix3d fitted_after(const SwimmerType& type, const Eigen::Matrix3d& turn, const Vec3& origin,
                             const Eigen::Matrix3d& near) {
  return fitted_orientation(type, columns(rest_positions(type, origin, turn)), near);
}

TEST(FittedOrientation, RecoversTheTurnOfATetrahedron) {
  std::mt19937 random(3);
  const SwimmerType type = with_beads_at({Vec3(0, 0, 0), Vec3(5, 0, 1), Vec3(1, 4, 0), Vec3(2, 1, 6)});
  for (int trial = 0; trial < 100; ++trial) {
    const Eigen::Matrix3d turn = random_rotation(random), near = random_rotation(random);
    const Eigen::Matrix3d fitted = fitted_after(type, turn, 10 * random_vector(random), near);
    constexpr double pull_of_near = 1e-11;
    EXPECT_LT(largest_entry(fitted - turn), pull_of_near);
  }
}

// A mirror image cannot be turned into the shape: the best rotation is proper all the same.
TEST(FittedOrientation, IsProperForPlanarAndMirroredShapes) {
  std::mt19937 random(4);
  constexpr double roundoff = 1e-14;
  const std::vector<Vec3> plane{Vec3(0, 0, 0), Vec3(5, 0, 0), Vec3(1, 4, 0), Vec3(7, 6, 0)};
  std::vector<Vec3> solid = plane;
  solid[3].z() = 5;
  for (int trial = 0; trial < 100; ++trial) {
    const Eigen::Matrix3d turn = random_rotation(random), near = random_rotation(random);
    const Eigen::Matrix3d fitted = fitted_after(with_beads_at(plane), turn, 10 * random_vector(random), near);
    expect_rotation(fitted, roundoff);
    EXPECT_LT(largest_entry(fitted - turn), 1e-11);
    expect_rotation(fitted_orientation(with_beads_at(solid), -columns(solid), near), roundoff);
  }
}

/// Returns the rotation nearest to `near` whose first column is `axis`: of all Q X with Q =
/// shortest_turn(axis) and a rotation X about x by an angle a, the one with the largest trace of (Q X)^T
/// near.
Eigen::Matrix3d nearest_with_axis(const Vec3& axis, const Eigen::Matrix3d& near) {
  const Eigen::Matrix3d turn = shortest_turn(axis), rest = turn.transpose() * near;
  const double a = std::atan2(rest(2, 1) - rest(1, 2), rest(1, 1) + rest(2, 2));
  return turn * Eigen::AngleAxisd(a, Vec3::UnitX()).toRotationMatrix();
}

TEST(FittedOrientation, OfAStraightSwimmerIsTheNearestAlongItsLine) {
  std::mt19937 random(5);
  const SwimmerType type = with_beads_at({Vec3(-4, 0, 0), Vec3(0, 0, 0), Vec3(7, 0, 0)});
  for (int trial = 0; trial < 100; ++trial) {
    const Eigen::Matrix3d near = random_rotation(random);
    // The axis is at most 1.2 rad from that of `near`; for opposite axes all rotations are as near.
    const Vec3 axis = near * axis_at(1.2 * trial / 100, trial);
    const Eigen::Matrix3d fitted = fitted_after(type, shortest_turn(axis), 10 * random_vector(random), near);
    EXPECT_LT((fitted.col(0) - axis).norm(), 1e-7);
    constexpr double conditioning = 1e-3;  // roundoff over the weight 1e-12 of `near`
    EXPECT_LT(largest_entry(fitted - nearest_with_axis(axis, near)), conditioning);
    expect_rotation(fitted, 1e-14);
  }
}

}  // namespace
}  // namespace beadswim
