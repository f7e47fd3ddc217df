#include "beadswim/swimmers/three_bead_swimmer.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <random>
#include <vector>

#include "beadswim/core/error.hpp"

namespace beadswim {
namespace {

/// Returns a three-bead swimmer in which all parameters differ.
ThreeBeadSwimmer random_swimmer(std::mt19937& random, DrivingFrame frame) {
  std::uniform_real_distribution<double> positive(0.1, 5), phase(-4, 4);
  ThreeBeadSwimmer swimmer;
  for (Bead& bead : swimmer.beads) bead = {.radius = positive(random), .density = positive(random)};
  for (Spring& spring : swimmer.springs)
    spring = {
        .stiffness = positive(random), .rest_length = 10 + positive(random), .damping = positive(random)};
  swimmer.angular_stiffness = positive(random);
  swimmer.driving = {.amplitude = {positive(random), -positive(random)},
                     .phase = phase(random),
                     .period = positive(random),
                     .frame = frame,
                     .phase_offset = phase(random)};
  return swimmer;
}

// Catches a parameter that is lost or exchanged on the way to the graph and back. Seed 1.
TEST(ThreeBeadForm, GivesBackTheSwimmer) {
  std::mt19937 random(1);
  for (const DrivingFrame frame : all_values<DrivingFrame>) {
    for (int trial = 0; trial < 20; ++trial) {
      const ThreeBeadSwimmer swimmer = random_swimmer(random, frame);
      EXPECT_EQ(three_bead_form(swimmer_type(swimmer)), swimmer) << to_text(frame);
      EXPECT_EQ(three_bead_form(drives(swimmer.driving)), swimmer.driving) << to_text(frame);
      EXPECT_EQ(three_beads(swimmer_type(swimmer)), swimmer) << to_text(frame);
    }
  }
}

TEST(ThreeBeadForm, FollowsBeadsAndSpringsOfTheGraph) {
  std::mt19937 random(1);
  ThreeBeadSwimmer swimmer = random_swimmer(random, DrivingFrame::lab);
  SwimmerType type = swimmer_type(swimmer);
  type.beads[1].radius = swimmer.beads[1].radius = 0.7;
  type.beads[2].density = swimmer.beads[2].density = 1.3;
  type.bonds[1].stiffness = swimmer.springs[1].stiffness = 0.2;
  type.angles[0].stiffness = swimmer.angular_stiffness = 8;
  EXPECT_EQ(three_bead_form(type), swimmer);
}

// Catches a part of the graph that is dropped in silence.
TEST(ThreeBeadForm, IsThatOfNoOtherGraph) {
  using Edit = std::function<void(SwimmerType&)>;
  const std::vector<Edit> any_frame{
      [](SwimmerType& type) {
        type.beads.push_back({{1, 1}, Vec3(30, 0, 0)});
      },
      [](SwimmerType& type) { type.beads[2].at.x() += 0.1; },
      [](SwimmerType& type) { type.beads[0].at.y() = 0.1; },
      [](SwimmerType& type) {
        type.bonds.push_back({{1, 20, 0}, {0, 2}});
      },
      [](SwimmerType& type) {
        type.bonds[1].beads = {0, 2};
      },
      [](SwimmerType& type) { type.angles.push_back(type.angles[0]); },
      [](SwimmerType& type) { type.angles[0].rest = 0.1; },
      [](SwimmerType& type) {
        type.angles[0].beads = {1, 0, 2};
      },
      [](SwimmerType& type) { type.driving.angles = {{.angle = 0, .harmonics = {{.amplitude = 1}}}}; },
      [](SwimmerType& type) { type.driving.bonds.push_back({.bond = 0, .harmonics = {{.amplitude = 1}}}); },
      [](SwimmerType& type) { type.driving.net_force = NetForce::allowed; }};
  const std::vector<Edit> forces{
      [](SwimmerType& type) { type.driving.forces[0].harmonics.push_back({.amplitude = 0.1}); },
      [](SwimmerType& type) { type.driving.forces[0].harmonics.clear(); },
      [](SwimmerType& type) { type.driving.forces[2].harmonics[0].multiple = 2; },
      [](SwimmerType& type) { type.driving.forces[0].constant = 0.1; },
      [](SwimmerType& type) { type.driving.forces[0].direction = Vec3::UnitY(); },
      [](SwimmerType& type) { type.driving.forces[1].harmonics[0].amplitude += 1; },
      [](SwimmerType& type) { type.driving.frame = DrivingFrame::body; }};
  const std::vector<Edit> tensions{
      [](SwimmerType& type) { type.driving.bonds[1].harmonics.push_back({.amplitude = 0.1}); },
      [](SwimmerType& type) { type.driving.bonds[0].harmonics[0].multiple = 2; },
      [](SwimmerType& type) { type.driving.bonds[0].harmonics[0].phase = 0.1; },
      [](SwimmerType& type) { type.driving.bonds[0].quantity = BondQuantity::rest_length; },
      [](SwimmerType& type) { type.driving.frame = DrivingFrame::lab; }};
  std::mt19937 random(1);
  const auto expect_none = [&](const std::vector<Edit>& edits, DrivingFrame frame) {
    for (std::size_t e = 0; e < edits.size(); ++e) {
      SwimmerType type = swimmer_type(random_swimmer(random, frame));
      edits[e](type);
      EXPECT_FALSE(three_bead_form(type)) << to_text(frame) << ", edit " << e;
      EXPECT_THROW(three_beads(type), InputError) << to_text(frame) << ", edit " << e;
    }
  };
  for (const DrivingFrame frame : all_values<DrivingFrame>) {
    expect_none(any_frame, frame);
    expect_none(frame == DrivingFrame::body ? tensions : forces, frame);
  }
}

}  // namespace
}  // namespace beadswim
