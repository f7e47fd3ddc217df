#include "beadswim/theory/closed_forms.hpp"

#include <gtest/gtest.h>

#include "beadswim/theory/linear_response.hpp"
#include "swimmers.hpp"

namespace beadswim {
namespace {

constexpr double roundoff = 1e-12;  // relative

PairMobility no_interaction(double, double, double, double) {
  return {};
}

std::vector<CollinearSwimmer> driven_swimmers() {
  std::vector<CollinearSwimmer> swimmers;
  for (const double B : {1.0, 0.3, -1.7}) {
    for (const double phase : {std::numbers::pi / 2, -0.4, 2.0}) {
      CollinearSwimmer swimmer = paper_swimmer(3300);
      swimmer.amplitude = {1, B};
      swimmer.phase = phase;
      swimmers.push_back(swimmer);
    }
  }
  return swimmers;
}

// v/A^2 of (4.3) for the paper's swimmer, printed to five digits.
TEST(OseenForceClosed, GivesReferenceVelocitiesOfThePapersSwimmer) {
  constexpr double printed_digits = 0.51e-7;
  const struct {
    double period, velocity;
  } rows[] = {{1000, 1.6784e-3}, {2000, 2.1316e-3}, {3000, 2.1627e-3},
              {4800, 1.9731e-3}, {8000, 1.5371e-3}, {10000, 1.3176e-3}};
  for (const auto& row : rows) {
    EXPECT_NEAR(oseen_force_velocity(paper_swimmer(row.period)), row.velocity, printed_digits) << row.period;
  }
}

// Towards bead 3 for A = B and alpha = pi/2: catches a swapped sign convention.
TEST(OseenForceClosed, MovesTowardsBead3ForPositivePhase) {
  EXPECT_GT(oseen_force_velocity(paper_swimmer(4800)), 0);
}

// (4.4), (4.5) are the linear response of three beads without interaction; solved here as matrices.
TEST(OseenStrokeClosed, AmplitudesAreThoseOfIsolatedBeads) {
  for (const CollinearSwimmer& swimmer : driven_swimmers()) {
    const Stroke stroke = first_order_stroke(swimmer, no_interaction);
    const std::array<double, 2> closed = oseen_arm_amplitudes(swimmer);
    EXPECT_NEAR(closed[0] / stroke.amplitude[0], 1, roundoff);
    EXPECT_NEAR(closed[1] / stroke.amplitude[1], 1, roundoff);
  }
}

TEST(OseenStrokeClosed, PhaseShiftIsThatOfIsolatedBeads) {
  for (const CollinearSwimmer& swimmer : driven_swimmers()) {
    EXPECT_NEAR(oseen_sin_phase_shift(swimmer), first_order_stroke(swimmer, no_interaction).sin_phase_shift(),
                roundoff);
  }
}

// (4.2) of the stroke (4.4) to (4.8) is (4.3) identically, whatever (4.9) says.
TEST(OseenStrokeClosed, EqualsForceFormForItsOwnStroke) {
  for (const CollinearSwimmer& swimmer : driven_swimmers()) {
    const Stroke stroke = first_order_stroke(swimmer, no_interaction);
    EXPECT_NEAR(oseen_stroke_velocity(swimmer, stroke) / oseen_force_velocity(swimmer), 1, roundoff);
  }
}

// Far apart, the untruncated expansion must reach its lowest order: three distances, first order in lambda/l.
TEST(OseenForceClosed, IsTheLimitOfThePerturbationForFarBeads) {
  const auto difference = [](double arm) {
    CollinearSwimmer swimmer = paper_swimmer(4800);
    swimmer.arm = {arm, arm};
    return std::abs(perturbation_velocity(swimmer, oseen) / oseen_force_velocity(swimmer) - 1);
  };
  constexpr double truncation = 0.02;  // of the slope, second order in lambda/l
  EXPECT_NEAR(std::log2(difference(2000) / difference(4000)), 1, truncation);
  EXPECT_NEAR(std::log2(difference(4000) / difference(8000)), 1, truncation);
  EXPECT_LT(difference(8000), 1e-3);
}

TEST(OseenClosed, IsFiniteWithoutDriving) {
  CollinearSwimmer swimmer = paper_swimmer(4800);
  swimmer.amplitude = {0, 0};
  EXPECT_EQ(oseen_force_velocity(swimmer), 0);
  EXPECT_EQ(oseen_sin_phase_shift(swimmer), 0);
  EXPECT_EQ(oseen_arm_amplitudes(swimmer), (std::array<double, 2>{0, 0}));
}

}  // namespace
}  // namespace beadswim
