// Tests of the warning of forces that keep their directions in the box while their swimmers are turned.
#include "beadswim/scene/check.hpp"

#include <gtest/gtest.h>

#include <numbers>

#include "beadswim/scene/gallery.hpp"
#include "beadswim/scene/presets.hpp"
#include "beadswim/swimmers/three_bead_swimmer.hpp"

namespace beadswim {
namespace {

constexpr double half_turn = std::numbers::pi;  // [radian]

/// Returns true if a lone swimmer of the type, turned by `angle` about `line`, is reported.
bool is_reported(const SwimmerType& type, double angle, const Vec3& line) {
  const Eigen::Quaterniond turn(Eigen::AngleAxisd(angle, line.normalized()));
  Layout layout;
  layout.types["a"] = type;
  layout.swimmers = {{.type = "a", .axis = turn * Vec3::UnitX(), .turn = turn}};
  return !warning_of_fixed_forces(layout).empty();
}

SwimmerType three_beads_in(DrivingFrame frame) {
  ThreeBeadSwimmer swimmer = three_beads(paper_single().types.at("a"));
  swimmer.driving.frame = frame;
  return swimmer_type(swimmer);
}

// A rotation about the line of the forces changes nothing. Any other does, however small, but for a reversal:
// it delays harmonic forces by half a period.
TEST(FixedForces, AreReportedIfTheirDirectionsChangeRelativeToTheSwimmer) {
  const SwimmerType type = three_beads_in(DrivingFrame::lab);
  EXPECT_FALSE(is_reported(type, 0, Vec3::UnitX()));
  EXPECT_FALSE(is_reported(type, 1, Vec3::UnitX()));
  EXPECT_FALSE(is_reported(type, half_turn, Vec3::UnitY()));
  EXPECT_TRUE(is_reported(type, half_turn / 2, Vec3::UnitY()));
  EXPECT_TRUE(is_reported(type, half_turn / 4, Vec3::UnitZ()));
  EXPECT_TRUE(is_reported(type, 1e-4, Vec3::UnitZ()));
  EXPECT_TRUE(is_reported(type, 3, Vec3(0, 1, 2)));
  EXPECT_FALSE(is_reported(three_beads_in(DrivingFrame::initial_axis), 1, Vec3::UnitY()));
  EXPECT_FALSE(is_reported(three_beads_in(DrivingFrame::body), 1, Vec3::UnitY()));
}

// The forces of the flagellum act along y: a roll about its axis turns them relative to the flagellum, a
// rotation about y does not. A constant force and a second harmonic, reversed, are no delay.
TEST(FixedForces, AreThoseOfTheTypeNotItsAxis) {
  SwimmerType flagellum = swimmer_type(Flagellum{}, paper_single().fluid);
  flagellum.driving.frame = DrivingFrame::lab;
  EXPECT_TRUE(is_reported(flagellum, half_turn / 2, Vec3::UnitX()));
  EXPECT_FALSE(is_reported(flagellum, half_turn, Vec3::UnitX()));
  EXPECT_FALSE(is_reported(flagellum, 1, Vec3::UnitY()));
  SwimmerType pulled = flagellum;
  pulled.driving.forces[0].constant = 1;
  pulled.driving.forces[1].constant = -1;
  EXPECT_FALSE(is_reported(pulled, 0, Vec3::UnitX()));
  EXPECT_TRUE(is_reported(pulled, half_turn, Vec3::UnitX()));
  for (ForceDrive& drive : flagellum.driving.forces)
    for (Harmonic& harmonic : drive.harmonics) harmonic.multiple = 2;
  EXPECT_TRUE(is_reported(flagellum, half_turn, Vec3::UnitX()));
}

// Weight is to act from outside, whatever the orientation; drives of bonds and angles have no direction.
TEST(FixedForces, AreNotThoseFromOutside) {
  const Fluid fluid = paper_single().fluid;
  EXPECT_FALSE(is_reported(swimmer_type(TowedChain{}, fluid), 1, Vec3(1, 2, 3)));
  EXPECT_FALSE(is_reported(swimmer_type(Triangle{}, fluid), 1, Vec3(1, 2, 3)));
}

TEST(FixedForces, AreCountedWithDrivingsOfSwimmersOwn) {
  Layout layout = paper_single();
  const Driving lab = layout.types.at("a").driving;
  layout.types.at("a") = three_beads_in(DrivingFrame::body);
  layout.swimmers.assign(5, layout.swimmers.front());
  for (Swimmer& swimmer : layout.swimmers) swimmer.axis = Vec3::UnitZ();
  EXPECT_EQ(warning_of_fixed_forces(layout), "");
  layout.swimmers[1].driving = layout.swimmers[3].driving = lab;
  EXPECT_NE(warning_of_fixed_forces(layout).find("the driving forces of 2 of 5 swimmers"), std::string::npos);
}

}  // namespace
}  // namespace beadswim
