#include "beadswim/theory/question.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "beadswim/core/error.hpp"
#include "beadswim/theory/inertia_corrected.hpp"
#include "swimmers.hpp"

namespace beadswim {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

CollinearSwimmer driven_by(double amplitude) {
  CollinearSwimmer s = paper_swimmer(4800);
  s.amplitude = {amplitude, amplitude};
  return s;
}

constexpr double tolerance = 0.05;  // of a user, on velocities

TEST(Warnings, AreNoneForASmallStroke) {
  EXPECT_THAT(warnings(ask(driven_by(0.1)), tolerance), IsEmpty());
}

// A = 0.4: four times the 1.6 % of A = 0.2 by the next order.
TEST(Warnings, SayThatTheDrivingIsBeyondSmallAmplitude) {
  EXPECT_THAT(warnings(ask(driven_by(0.4)), tolerance),
              ElementsAre(AllOf(HasSubstr("amplitude is not small"), HasSubstr("about +6.3 %"),
                                HasSubstr("tolerance of 5 %"), HasSubstr("names end in -ode"))));
}

// A = 0.5: arm 2 swings by half of 26.66, its gap is 12.
TEST(Warnings, SayThatBeadsMeetWithinTheStroke) {
  EXPECT_THAT(
      warnings(ask(driven_by(0.5)), tolerance),
      ElementsAre(AllOf(HasSubstr("beads would touch during the stroke"), HasSubstr("9.056 and 13.33"),
                        HasSubstr("at rest are 12 and 12"), HasSubstr("lower amplitude or raise stiffness")),
                  HasSubstr("amplitude is not small")));
}

TEST(Warnings, AreGivenWithoutAnExactReferenceToo) {
  CollinearSwimmer s = driven_by(0.5);
  s.arm = {8.004, 8.004};
  ASSERT_FALSE(ask(s).exact());
  EXPECT_THAT(warnings(ask(s), tolerance),
              testing::Contains(HasSubstr("beads would touch during the stroke")));
}

TEST(Warnings, OfBeadsThatOverlapAtRestAreOfTheirMeeting) {
  CollinearSwimmer s = driven_by(0.1);
  s.arm = {7.9, 7.9};
  EXPECT_THAT(warnings(ask(s), tolerance), ElementsAre(HasSubstr("beads would touch during the stroke")));
}

TEST(ExactReference, IsTheMotionByExactMobilities) {
  const CollinearSwimmer s = unequal_swimmer();
  const PeriodicMotion expected = second_order_motion(s, exact_mobility(s, rest_positions(s)));
  EXPECT_EQ(ask(s).exact()->motion.velocity, expected.velocity);
}

// The result does not depend on what was asked before: a question is complete when it is made.
TEST(ExactReference, RefusalsStateItsOwnReason) {
  CollinearSwimmer s = driven_by(0.1);
  EXPECT_EQ(obstacle(find_method("multipole-ode"), Question(s, 1)), "");
  s.arm = {8.004, 8.004};
  EXPECT_THAT(obstacle(find_method("multipole-ode"), Question(s, 1)),
              AllOf(HasSubstr("multipoles of order"), HasSubstr("use the less accurate method")));
  EXPECT_THROW(inertia_corrected(ask(s)), InputError);
}

TEST(ExactReference, IsNoneForOverlap) {
  CollinearSwimmer s = driven_by(0.1);
  s.arm = {7.9, 7.9};
  EXPECT_FALSE(ask(s).exact());
}

}  // namespace
}  // namespace beadswim
