#include "beadswim/swimmers/swimmer_shape.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "bead_vectors.hpp"
#include "beadswim/swimmers/swimmer_forces.hpp"

namespace beadswim {
namespace {

constexpr double ahead = std::numbers::pi / 2;  // phase of drives that are largest at time 0
constexpr double length_roundoff = 1e-12;

SwimmerType beads_at(const std::vector<Vec3>& places) {
  SwimmerType type;
  for (const Vec3& place : places) type.beads.push_back({{.radius = 1, .density = 1}, place});
  type.driving.period = 100;
  return type;
}

/// Joins two beads by a bond of length `rest`, to which a drive adds `change` at time 0.
void add_bond(SwimmerType& type, int i, int j, double rest, double change, double stiffness = 1) {
  const int bond = static_cast<int>(type.bonds.size());
  type.bonds.push_back({{.stiffness = stiffness, .rest_length = rest}, {i, j}});
  type.driving.bonds.push_back({.bond = bond,
                                .quantity = BondQuantity::rest_length,
                                .harmonics = {{.amplitude = change, .phase = ahead}}});
}

BeadVectors places_of(const SwimmerType& type) {
  return columns(rest_positions(type, Vec3::Zero(), Eigen::Matrix3d::Identity()));
}

/// Checks that every spring has its length or angle of time 0, and that position and orientation are those of
/// the beads at rest.
void expect_relaxed(const SwimmerType& type, const SwimmerType& start) {
  const BeadVectors beads = places_of(start), at = places_of(type);
  for (std::size_t k = 0; k < type.bonds.size(); ++k) {
    const auto [i, j] = type.bonds[k].beads;
    EXPECT_NEAR((beads.col(j) - beads.col(i)).norm(), rest_length(type, k, 0), length_roundoff)
        << "bond " << k;
  }
  for (std::size_t k = 0; k < type.angles.size(); ++k) {
    const AngleSides sides = sides_of(type.angles[k], beads);
    EXPECT_NEAR(std::atan2(sides.sine, sides.cosine), rest_angle(type, k, 0), length_roundoff)
        << "angle " << k;
  }
  EXPECT_LT((beads.rowwise().mean() - at.rowwise().mean()).norm(), length_roundoff);
  const Eigen::Matrix3d unit = Eigen::Matrix3d::Identity();
  EXPECT_LT((fitted_orientation(type, beads, unit) - unit).norm(), length_roundoff);
}

SwimmerType triangle() {
  SwimmerType type = beads_at({Vec3(3, 1, 2), Vec3(11, 1, 4), Vec3(6, 7, 0)});
  for (int k = 0; k < 3; ++k) add_bond(type, k, (k + 1) % 3, 8, std::array{2.0, -1.5, 0.5}[k]);
  return type;
}

// The lengths follow from the drives alone, wherever the beads are at rest.
TEST(StartingShape, HasTheDrivenLengths) {
  for (const double offset : {0.0, 0.7, 2.0, 3.1, -2.5}) {
    SwimmerType type = triangle();
    type.driving.phase_offset = offset;
    expect_relaxed(type, at_start(type));
  }
}

TEST(StartingShape, DoesNotDependOnTheStiffness) {
  SwimmerType soft = triangle();
  for (int k = 0; k < 3; ++k) soft.bonds[k].stiffness = std::pow(10.0, -3 * k);
  EXPECT_LT((places_of(at_start(soft)) - places_of(at_start(triangle()))).norm(), 1e-3);
  expect_relaxed(soft, at_start(soft));
}

// A mirror image of a tetrahedron has the same lengths.
TEST(StartingShape, KeepsItsChirality) {
  for (const double mirror : {1.0, -1.0}) {
    SwimmerType type = beads_at({Vec3(0, 0, 0), Vec3(9, 1, 0), Vec3(2, 8, 0), Vec3(3, 3, 4 * mirror)});
    for (int i = 0; i < 4; ++i)
      for (int j = 0; j < i; ++j)
        add_bond(type, i, j, distance_at_rest(type, i, j), 0.8 * std::sin(3 * i + 5 * j));
    const SwimmerType start = at_start(type);
    expect_relaxed(type, start);
    const auto side = [&](int b) -> Vec3 { return start.beads[b].at - start.beads[0].at; };
    EXPECT_GT(mirror * side(1).cross(side(2)).dot(side(3)), 0);
  }
}

// Two hinges bend to opposite sides, as a Z, by angles that change by up to 1.2; the other joints stay
// straight.
TEST(StartingShape, KeepsTheSidesOfAngles) {
  std::vector<Vec3> places;
  for (int b = 0; b < 10; ++b) {
    const double along = std::clamp(b, 3, 6) * 5, out = b < 3 ? b - 3 : std::max(b - 6, 0);
    places.push_back(Vec3(along + 5 * out * std::cos(0.9), 5 * out * std::sin(0.9), 0));
  }
  for (const double change : {-0.7, 0.5, 1.2}) {
    SwimmerType type = beads_at(places);
    for (int b = 0; b < 9; ++b) type.bonds.push_back({{.stiffness = 2, .rest_length = 5}, {b, b + 1}});
    for (int b = 0; b < 8; ++b)
      type.angles.push_back(
          {.beads = {b, b + 1, b + 2}, .stiffness = 30, .rest = b == 2 || b == 5 ? 0.9 : 0});
    for (const int hinge : {2, 5})
      type.driving.angles.push_back(
          {.angle = hinge, .harmonics = {{.amplitude = hinge == 2 ? change : -change / 2, .phase = ahead}}});
    const SwimmerType start = at_start(type);
    expect_relaxed(type, start);
    const auto bond = [&](int b) -> Vec3 { return start.beads[b + 1].at - start.beads[b].at; };
    EXPECT_LT(bond(2).cross(bond(3)).z(), 0);
    EXPECT_GT(bond(5).cross(bond(6)).z(), 0);
    for (const BeadAtRest& bead : start.beads) EXPECT_EQ(bead.at.z(), 0);
  }
}

// The smallest displacement that lengthens one of two bonds at a right angle by a small d: without the bond's
// own direction, no bead moves. Its tension moves beads 1 and 2 by -d/2 and d/2 along x; the free bead 3
// would then lengthen nothing, because its bond is across.
TEST(StartingShape, MovesBeadsAsLittleAsPossible) {
  constexpr double d = 1e-5;
  SwimmerType type = beads_at({Vec3(0, 0, 0), Vec3(5, 0, 0), Vec3(5, 5, 0)});
  add_bond(type, 0, 1, 5, d);
  add_bond(type, 1, 2, 5, 0);
  const BeadVectors moved = places_of(at_start(type)) - places_of(type);
  EXPECT_LT((moved - d / 2 * columns({-Vec3::UnitX(), Vec3::UnitX(), Vec3::Zero()})).norm(), 1e-4 * d);
}

TEST(StartingShape, OfBeadsInLineIsInLine) {
  SwimmerType type = beads_at({Vec3(-6, 0, 0), Vec3(0, 0, 0), Vec3(6, 0, 0)});
  add_bond(type, 0, 1, 6, 1.3);
  add_bond(type, 1, 2, 6, -0.7);
  type.angles = {{.beads = {0, 1, 2}, .stiffness = 50}};
  const SwimmerType start = at_start(type);
  expect_relaxed(type, start);
  EXPECT_TRUE(is_straight(start));
}

// Springs that work against one another: the forces are balanced.
TEST(StartingShape, BalancesSpringsThatDoNotFitTogether) {
  SwimmerType type = triangle();
  type.angles = {{.beads = {0, 1, 2}, .stiffness = 20, .rest = 1.2}};
  const RelaxedShape shape = relaxed_shape(type);
  EXPECT_TRUE(shape.is_converged);
  const BeadVectors bonds = bond_forces(type, 0, shape.beads, 0 * shape.beads);
  EXPECT_LT((bonds + angle_forces(type, 0, shape.beads)).norm(), 1e-10);
  EXPECT_GT(bonds.norm(), 0.1);
}

// Sides that form no triangle end in the shape of smallest energy, in line, and not elsewhere.
TEST(StartingShape, ExistsWhereNoShapeHasTheDrivenLengths) {
  SwimmerType type = beads_at({Vec3(0, 0, 0), Vec3(5, 0, 0), Vec3(3, 4, 0)});
  add_bond(type, 0, 1, 20, 0);
  add_bond(type, 1, 2, 6, 0);
  add_bond(type, 2, 0, 8, 0);
  const SwimmerType start = at_start(type);  // lengths l + x, l - x/..: all tensions are equal in size
  EXPECT_NEAR(distance_at_rest(start, 0, 1), 18, 1e-3);
  EXPECT_NEAR(distance_at_rest(start, 1, 2), 8, 1e-3);
  EXPECT_NEAR(distance_at_rest(start, 2, 0), 10, 1e-3);
}

// What no drive prescribes is as the layout has it: stretched springs without drives, and tensions.
TEST(StartingShape, IsThatAtRestWithoutDrivenLengthsOrAngles) {
  SwimmerType type = triangle();
  type.driving.bonds = {{.bond = 0, .quantity = BondQuantity::tension, .harmonics = {{.amplitude = 1}}}};
  EXPECT_EQ(at_start(type), type);
}

TEST(StartingShape, OfARelaxedTypeHasTheSameBits) {
  const SwimmerType start = at_start(triangle());
  EXPECT_EQ(at_start(start), start);
}

}  // namespace
}  // namespace beadswim
