#include <gtest/gtest.h>

#include <algorithm>

#include "beadswim/theory/methods.hpp"
#include "swimmers.hpp"

// Tests of symmetries that hold for every swimmer in Stokes flow at finite amplitude, for every pair
// mobility.

namespace beadswim {
namespace {

class FiniteAmplitudeSymmetry : public testing::TestWithParam<const char*> {
 protected:
  static double velocity_of(const CollinearSwimmer& s) { return prediction_of(GetParam(), s).velocity; }
  /// Returns omega d, the speed of a bead.
  static double bead_speed(const CollinearSwimmer& s) {
    const Stroke stroke = prediction_of(GetParam(), s).stroke;
    return s.angular_frequency() * std::max(stroke.amplitude[0], stroke.amplitude[1]);
  }
};

constexpr double cycle_roundoff = 1e-13;  // of a bead's speed
constexpr double nine_digits = 1e-9;

CollinearSwimmer strongly_driven(CollinearSwimmer s) {
  s.amplitude = {0.3, 0.3};
  return s;
}

TEST_P(FiniteAmplitudeSymmetry, MirroredSwimmerMovesTheOtherWay) {
  CollinearSwimmer s = unequal_swimmer();
  s.amplitude = {0.3, 0.2};
  EXPECT_NEAR(velocity_of(mirrored(s)) / velocity_of(s), -1, nine_digits);
}

TEST_P(FiniteAmplitudeSymmetry, OppositePhaseMovesEqualSwimmerTheOtherWay) {
  CollinearSwimmer s = strongly_driven(paper_swimmer(4800));
  s.phase = 0.7;
  const double forward = velocity_of(s);
  s.phase = -0.7;
  EXPECT_NEAR(velocity_of(s) / forward, -1, nine_digits);
}

TEST_P(FiniteAmplitudeSymmetry, DoesNotMoveWhenDrivenInPhaseOrInAntiphase) {
  for (const double phase : {0.0, std::numbers::pi}) {
    CollinearSwimmer s = strongly_driven(paper_swimmer(4800));
    s.phase = phase;
    EXPECT_LT(std::abs(velocity_of(s)), cycle_roundoff * bead_speed(s));
  }
}

// Scallop theorem at 20 % of the gap: one arm held, all but rigid.
TEST_P(FiniteAmplitudeSymmetry, DoesNotMoveWithOneRigidArm) {
  CollinearSwimmer s = unequal_swimmer();
  s.amplitude = {0.3, 0.2};
  s.stiffness[1] = 1e9;
  s.damping[1] = 0;
  constexpr double truncation = 1e-9;  // of the bead's speed: the arm still yields by F/k
  EXPECT_LT(std::abs(velocity_of(s)), truncation * bead_speed(s));
}

// Half a period later and with all forces reversed: the same motion.
TEST_P(FiniteAmplitudeSymmetry, ReversedForcesMoveItTheSameWay) {
  CollinearSwimmer s = strongly_driven(unequal_swimmer());
  const double forward = velocity_of(s);
  for (double& amplitude : s.amplitude) amplitude *= -1;
  EXPECT_NEAR(velocity_of(s) / forward, 1, nine_digits);
}

INSTANTIATE_TEST_SUITE_P(Methods, FiniteAmplitudeSymmetry,
                         testing::Values("oseen-ode", "rpy-ode", "multipole-ode"), [](const auto& info) {
                           std::string name = info.param;
                           std::replace(name.begin(), name.end(), '-', '_');
                           return name;
                         });

}  // namespace
}  // namespace beadswim
