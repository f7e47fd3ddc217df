#include "beadswim/theory/collinear_swimmer.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "beadswim/core/error.hpp"

namespace beadswim {
namespace {

ThreeBeadSwimmer type_of_frame(DrivingFrame frame) {
  ThreeBeadSwimmer type;
  type.beads = {Bead{4, 1}, Bead{3, 1.5}, Bead{5, 0.8}};
  type.springs = {Spring{0.03, 20, 1}, Spring{0.05, 26, 2}};
  type.driving = {.amplitude = {0.2, 0.1}, .phase = 1, .period = 3000, .frame = frame};
  return type;
}

TEST(CollinearSwimmer, TakesEveryPartOfTheTypeInOrder) {
  const CollinearSwimmer expected{.radius = {4, 3, 5},
                                  .density = {1, 1.5, 0.8},
                                  .arm = {20, 26},
                                  .stiffness = {0.03, 0.05},
                                  .damping = {1, 2},
                                  .amplitude = {0.2, 0.1},
                                  .phase = 1,
                                  .period = 3000,
                                  .viscosity = 0.25};
  EXPECT_EQ(collinear_swimmer(type_of_frame(DrivingFrame::lab), Vec3::UnitX(), 0.25), expected);
}

// The external field points along x; a swimmer that lies the other way feels it backwards.
TEST(CollinearSwimmer, FeelsTheLabFieldBackwardsAlongMinusX) {
  const CollinearSwimmer swimmer = collinear_swimmer(type_of_frame(DrivingFrame::lab), -Vec3::UnitX(), 0.25);
  EXPECT_EQ(swimmer.amplitude, (std::array<double, 2>{-0.2, -0.1}));
}

TEST(CollinearSwimmer, RefusesTheLabFieldAcrossTheAxis) {
  try {
    collinear_swimmer(type_of_frame(DrivingFrame::lab), Vec3(1, 1, 0).normalized(), 0.25);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("not along x"));
  }
}

TEST(CollinearSwimmer, TakesAnyAxisWhenDrivenAlongIt) {
  for (const DrivingFrame frame : {DrivingFrame::initial_axis, DrivingFrame::body}) {
    const CollinearSwimmer swimmer = collinear_swimmer(type_of_frame(frame), Vec3(1, 2, 2) / 3, 0.25);
    EXPECT_EQ(swimmer.amplitude, (std::array<double, 2>{0.2, 0.1}));
  }
}

TEST(CollinearSwimmer, SeparationIsTheNearestPairsOverItsMeanRadius) {
  CollinearSwimmer swimmer;
  swimmer.radius = {4, 6, 4};
  swimmer.arm = {30, 20};
  EXPECT_EQ(separation_ratio(swimmer), 4);
}

TEST(CollinearSwimmer, RefusesASpringWithoutStiffness) {
  ThreeBeadSwimmer type = type_of_frame(DrivingFrame::lab);
  type.springs[1].stiffness = 0;
  EXPECT_THROW(collinear_swimmer(type, Vec3::UnitX(), 0.25), InputError);
}

}  // namespace
}  // namespace beadswim
