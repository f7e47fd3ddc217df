#include "beadswim/scene/check.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "beadswim/scene/presets.hpp"
#include "three_bead_types.hpp"

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

TEST(CheckLayout, NamesAnUnknownTypeAndTheNearest) {
  Layout layout = small_scene();
  layout.types["swimmer"] = layout.types["a"];
  layout.swimmers[0].type = "swimer";
  EXPECT_THAT(faults(layout),
              testing::StartsWith("/swimmers/0/type: the swimmer type \"swimer\" is not defined"));
  EXPECT_THAT(faults(layout), HasSubstr("\"swimmer\"?"));
}

TEST(CheckLayout, RefusesAnIdGivenTwice) {
  Layout layout = small_scene();
  layout.swimmers.push_back(layout.swimmers[0]);
  EXPECT_EQ(faults(layout),
            "/swimmers/1/id: the id 0 is already used by /swimmers/0; give each swimmer another id\n");
}

TEST(CheckLayout, RefusesAnAxisThatIsNotAUnitVector) {
  Layout layout = small_scene();
  layout.swimmers[0].axis = Vec3(3, 0, 4);
  EXPECT_THAT(
      faults(layout),
      HasSubstr(
          "/swimmers/0/axis: the axis (3, 0, 4) has the length 5, but must be a unit vector; divided by "
          "its length it is (0.6, 0, 0.8)"));
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

TEST(CheckLayout, RefusesAnArmShorterThanItsBeads) {
  Layout layout = small_scene();
  change(layout.types["a"], [](ThreeBeadSwimmer& type) {
    type.springs[1].rest_length = 8;  // the sum of the radii: touching
  });
  EXPECT_THAT(faults(layout),
              HasSubstr("/types/a/springs/1/rest_length: with the rest length 8, beads 2 and 3 overlap"));
}

TEST(CheckLayout, RefusesBead2OutsideTheBox) {
  Layout layout = small_scene();
  layout.swimmers[0].position = Vec3(72.5, 15, 15);
  EXPECT_THAT(faults(layout),
              HasSubstr("/swimmers/0/position: the position (72.5, 15, 15) of bead 2 lies outside the box"));
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

TEST(CheckLayout, RefusesABeadThatPiercesAWallWithItsCentreInside) {
  Layout layout = small_scene();
  layout.domain.box->boundary[2] = Boundary::no_slip;
  layout.swimmers[0].position[2] = 3.5;
  EXPECT_THAT(faults(layout), HasSubstr("along z: its centre must be between 4 and 26"));
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

TEST(CheckLayout, RefusesAUnitThatContradictsItsName) {
  Layout layout = small_scene();
  layout.units = {.lattice = false, .length = {"um", 1e-6}, .time = {"ms", 1}, .mass = {"jelly bean", 1e-3}};
  EXPECT_EQ(faults(layout),
            "/units/time/si_factor: the factor 1 is wrong: one ms is 0.001 in SI units; give that factor or "
            "another unit name\n");
}

}  // namespace
}  // namespace beadswim
