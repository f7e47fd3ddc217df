#include "beadswim/scene/check.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "beadswim/scene/presets.hpp"
#include "beadswim/swimmers/hinges.hpp"

namespace beadswim {
namespace {

using testing::HasSubstr;

/// Returns the paper's swimmer in a small periodic box, with beads at x = 16, 36, 56.
Layout small_scene() {
  Layout layout = paper_single();
  layout.domain.box = Box{.lengths = Vec3(72, 30, 30), .boundary = {}};
  layout.swimmers[0].position = Vec3(36, 15, 15);
  return layout;
}

/// Returns the faults of a layout as text, one line "place: message" per fault.
std::string faults(const Layout& layout) {
  std::string text;
  for (const LayoutFault& fault : check_layout(layout)) text += fault.place + ": " + fault.message + "\n";
  return text;
}

TEST(CheckLayout, FindsNothingWrongWithThePaper) {
  EXPECT_EQ(faults(paper_single()), "");
  EXPECT_EQ(faults(small_scene()), "");
}

TEST(NormaliseAxes, RoundsToUnitLengthAndLeavesUnitVectorsBitwise) {
  Layout layout = small_scene();
  layout.swimmers[0].axis = Vec3(0.8, 0.6, 0) * (1 + 5e-7);
  normalise_axes(layout);
  EXPECT_NEAR(layout.swimmers[0].axis.norm(), 1, 1e-15);
  const Vec3 once = layout.swimmers[0].axis;
  normalise_axes(layout);
  EXPECT_EQ(layout.swimmers[0].axis, once);
}

// Bonds use unwrapped coordinates, so an arm across the periodic seam is no fault; across a wall it is.
TEST(CheckLayout, LetsArmsCrossASeamButNotAWall) {
  Layout layout = small_scene();
  layout.swimmers[0].position = Vec3(10, 15, 15);
  EXPECT_EQ(faults(layout), "");
  layout.domain.box->boundary[0] = Boundary::free_slip;
  EXPECT_THAT(faults(layout),
              HasSubstr("bead 1 of radius 4 at (-10, 15, 15) is not completely between the walls along x"));
}

TEST(CheckLayout, NamesBothSwimmersOfAnOverlap) {
  Layout layout = small_scene();
  Swimmer second = layout.swimmers[0];
  second.id = 7;
  second.position[1] += 7;
  layout.swimmers.push_back(second);
  const auto found = check_layout(layout);
  ASSERT_EQ(found.size(), 1u);  // all three beads overlap; one is told
  EXPECT_EQ(found[0].place, "/swimmers/1/position");
  EXPECT_THAT(found[0].message,
              HasSubstr("bead 1 of swimmer 7 at (16, 22, 15) overlaps bead 1 of swimmer 0"));
  EXPECT_THAT(found[0].message, HasSubstr("7 apart, but must be more than 8"));
}

// An arm as long as the box lays bead 1 on the image of bead 2: the smallest such box must be refused.
TEST(CheckLayout, RefusesABoxSoShortThatASwimmerMeetsItsOwnImages) {
  Layout layout = small_scene();
  layout.swimmers[0].position = Vec3(10, 15, 15);
  layout.domain.box->lengths[0] = 48.5;  // bead 3 and the image of bead 1 are 8.5 apart
  EXPECT_EQ(faults(layout), "");
  layout.domain.box->lengths[0] = 47.5;
  EXPECT_THAT(faults(layout), HasSubstr("through the periodic boundary"));
}

/// Returns four beads on the x axis with two hinges about z that oscillate by `amplitude`, hinge 2 ahead of
/// hinge 1 by `phase`.
Layout hinged_scene(double amplitude, double phase) {
  SwimmerType type;
  for (const double x : {-15.0, -5.0, 5.0, 15.0})
    type.beads.push_back({{.radius = 2, .density = 1}, {x, 0, 0}});
  for (int b = 0; b < 3; ++b) type.bonds.push_back({{1, 10, 0}, {b, b + 1}});
  type.driving.period = 100;
  for (int k = 0; k < 2; ++k) {
    type.angles.push_back({.beads = {k, k + 1, k + 2}, .stiffness = 100, .normal = Vec3::UnitZ()});
    type.driving.angles.push_back({.angle = k, .harmonics = {{.amplitude = amplitude, .phase = k * phase}}});
  }
  Layout layout = small_scene();
  layout.types = {{"chain", type}};
  layout.swimmers[0].type = "chain";
  return layout;
}

TEST(CheckHinges, LetsThemPassStraightInTurn) {
  EXPECT_EQ(faults(hinged_scene(1, 1.6)), "");
  Layout bare = hinged_scene(1, 1.6);
  for (Angle& angle : bare.types["chain"].angles) angle.normal.reset();
  EXPECT_THAT(faults(bare), HasSubstr("/types/chain/driving/angles/0: the three beads are in line"));
  bare.types["chain"].driving.angles.clear();
  EXPECT_EQ(faults(bare), "");
  bare.types["chain"].angles[1].rest = -0.1;
  EXPECT_THAT(faults(bare), HasSubstr("/types/chain/angles/1/rest: the rest angle -0.1 is negative"));
}

TEST(CheckHinges, RefusesThoseThatDoNotDetermineTheOrientation) {
  EXPECT_THAT(faults(hinged_scene(1, 0.0)), HasSubstr("all beads come in line in the cycle"));
  Layout bent = hinged_scene(1, 1.6);
  SwimmerType& type = bent.types["chain"];
  type = at_rest_angles(type, 0);
  EXPECT_THAT(faults(bent), HasSubstr("/types/chain/beads: the hinges bend the swimmer to the mirror image"));
  Layout still = hinged_scene(0, 0);
  still.types["chain"].driving.angles.clear();
  EXPECT_EQ(faults(still), "");
  still.types["chain"].angles[0].rest = 0.5;
  EXPECT_THAT(faults(still), HasSubstr("/types/chain/beads: all beads are in line"));
}

TEST(CheckHinges, RefusesNormalsThatAreNone) {
  EXPECT_THAT(faults(hinged_scene(4, 1.6)), HasSubstr("must stay between -pi and pi"));
  Layout tilted = hinged_scene(1, 1.6), ring = tilted;
  tilted.types["chain"].angles[1].normal = Vec3(0.6, 0, 0.8);
  EXPECT_THAT(faults(tilted), HasSubstr("/types/chain/angles/1/normal: the normal (0.6, 0, 0.8) is not"));
  ring.types["chain"].bonds.push_back({{1, 20, 0}, {0, 2}});
  EXPECT_THAT(faults(ring),
              HasSubstr("/types/chain/angles/0/normal: bonds join beads 1 and 3 also past bead 2"));
}

}  // namespace
}  // namespace beadswim
