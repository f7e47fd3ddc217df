#include "beadswim/theory/linear_response.hpp"

#include <gtest/gtest.h>

#include "swimmers.hpp"

namespace beadswim {
namespace {

// Beads 1 and 2 alone, bead 3 far away and undriven: gamma/2 dL/dt = -k (L - l) - c dL/dt - A sin(wt), so
// d = A / |k + i omega (c + gamma/2)|. Catches a dashpot that acts on a bead's own velocity.
TEST(LinearResponse, DashpotAddsToTheDragOfItsArm) {
  constexpr double truncation = 1e-8;  // the far arm's spring: soft, so that it transmits nothing
  CollinearSwimmer swimmer = paper_swimmer(3000);
  swimmer.arm = {1e10, 1e10};
  swimmer.stiffness = {0.0347, 1e-12};
  swimmer.damping = {5, 0};
  swimmer.amplitude = {1, 0};
  const double gamma = 6 * std::numbers::pi * swimmer.viscosity * 4, omega = swimmer.angular_frequency();
  const double expected = 1 / std::hypot(0.0347, omega * (5 + gamma / 2));
  EXPECT_NEAR(first_order_stroke(swimmer, oseen).amplitude[0] / expected, 1, truncation);
}

// Slow driving: springs balance forces, L1 - l = -A sin(wt)/k = (A/k) cos(wt + pi/2), and for alpha = 0
// L2 - l = B sin(wt)/k = (B/k) cos(wt - pi/2). Catches a wrong phase convention.
TEST(LinearResponse, FollowsSlowDrivingInPhase) {
  CollinearSwimmer swimmer = paper_swimmer(1e12);
  swimmer.amplitude = {2, 3};
  swimmer.phase = 0;
  constexpr double truncation = 1e-7;  // gamma omega / k
  const Stroke stroke = first_order_stroke(swimmer, rotne_prager);
  EXPECT_NEAR(stroke.amplitude[0] * 0.0347 / 2, 1, truncation);
  EXPECT_NEAR(stroke.amplitude[1] * 0.0347 / 3, 1, truncation);
  EXPECT_NEAR(stroke.phase[0], std::numbers::pi / 2, truncation);
  EXPECT_NEAR(stroke.phase[1], -std::numbers::pi / 2, truncation);
}

TEST(Stroke, OfArmsAtRestHasZeroPhasesAndNoShift) {
  const Stroke rest =
      stroke_of(Eigen::Vector2cd(std::complex<double>(-0.0, 0.0), std::complex<double>(-0.0, -0.0)));
  EXPECT_EQ(rest.phase, (std::vector<double>{0, 0}));
  EXPECT_EQ(rest.sin_phase_shift(), 0);
  const Stroke one_arm = stroke_of(Eigen::Vector2cd(std::complex<double>(0, 2), std::complex<double>(0, 0)));
  EXPECT_EQ(one_arm.sin_phase_shift(), 0);
}

TEST(Stroke, PhaseIsPiAndNeverMinusPi) {
  const Stroke stroke =
      stroke_of(Eigen::Vector2cd(std::complex<double>(-1.0, -0.0), std::complex<double>(-1.0, 0.0)));
  EXPECT_EQ(stroke.phase, (std::vector<double>{std::numbers::pi, std::numbers::pi}));
}

}  // namespace
}  // namespace beadswim
