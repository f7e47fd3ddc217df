#include <gtest/gtest.h>

#include <functional>

#include "beadswim/theory/closed_forms.hpp"
#include "beadswim/theory/linear_response.hpp"
#include "swimmers.hpp"

// Tests how much the pair mobilities of Oseen and of Rotne and Prager differ from exact Stokes flow, and from
// each other.

namespace beadswim {
namespace {

/// Returns the paper's swimmer with arms of `separation` bead radii.
CollinearSwimmer swimmer_at(double separation) {
  CollinearSwimmer s = paper_swimmer(4800);
  s.arm = {4 * separation, 4 * separation};
  return s;
}

double exact_velocity_for_stroke(const CollinearSwimmer& s) {
  return ask(s).exact()->motion.velocity;
}

/// Checks that error(l/lambda) decreases with this order from 20 to 40 and 80, and is smaller than `finest`
/// at 80.
void expect_order(const std::function<double(double)>& error, double order, double finest) {
  constexpr double truncation = 0.05;  // of the slope: one order more in lambda/l
  EXPECT_NEAR(std::log2(error(20) / error(40)), order, truncation);
  EXPECT_NEAR(std::log2(error(40) / error(80)), order, truncation);
  EXPECT_LT(std::abs(error(80)), finest);
}

CollinearSwimmer asymmetrically_driven(double separation) {
  CollinearSwimmer s = swimmer_at(separation);
  s.amplitude = {1, 0.7};
  s.phase = 1.1;
  return s;
}

TEST(PairLawLimits, RotnePragerIsOffExactVelocitiesByTheThirdOrder) {
  expect_order(
      [](double separation) {
        const CollinearSwimmer s = asymmetrically_driven(separation);
        return perturbation_velocity(s, rotne_prager) / exact_velocity_for_stroke(s) - 1;
      },
      3, 5e-5);
}

TEST(PairLawLimits, RotnePragerIsOffOseenVelocitiesByTheSecondOrder) {
  expect_order(
      [](double separation) {
        const CollinearSwimmer s = asymmetrically_driven(separation);
        return perturbation_velocity(s, rotne_prager) / perturbation_velocity(s, oseen) - 1;
      },
      2, 5e-4);
}

TEST(PairLawLimits, AtFiniteAmplitudeTheyConvergeAlike) {
  expect_order(
      [](double separation) {
        CollinearSwimmer s = asymmetrically_driven(separation);
        s.amplitude = {0.3, 0.21};
        return prediction_of("rpy-ode", s).velocity / prediction_of("multipole-ode", s).velocity - 1;
      },
      3, 5e-5);
}

// T = 4800, small amplitude; from an independent three-sphere multipole solution, printed to three decimals.
TEST(PairLawLimits, RatiosToExactFlowAreTheReferenceOnes) {
  constexpr double printed_digits = 1e-3;  // one of the last: 1.0375 is printed as 1.037
  const struct {
    double separation, oseen, rotne_prager, closed;
  } rows[] = {{3, 2.258, 1.613, 1.946}, {4, 1.458, 1.239, 1.339}, {5, 1.234, 1.118, 1.159},
              {6, 1.140, 1.067, 1.085}, {8, 1.066, 1.028, 1.028}, {10, 1.037, 1.014, 1.009},
              {20, 1.007, 1.002, 0.994}};
  for (const auto& row : rows) {
    const CollinearSwimmer s = swimmer_at(row.separation);
    const double exact = exact_velocity_for_stroke(s);
    EXPECT_NEAR(perturbation_velocity(s, oseen) / exact, row.oseen, printed_digits) << row.separation;
    EXPECT_NEAR(perturbation_velocity(s, rotne_prager) / exact, row.rotne_prager, printed_digits)
        << row.separation;
    EXPECT_NEAR(oseen_force_velocity(s) / exact, row.closed, printed_digits) << row.separation;
  }
}

// v/A^2 of the paper's swimmer, from an independent calculation printed to five digits.
TEST(PairLawLimits, RotnePragerMotionOfThePapersSwimmerIsTheReferenceOne) {
  constexpr double printed_digits = 0.51e-7;
  const struct {
    double period, velocity;
  } rows[] = {{1000, 1.1738e-3}, {2000, 1.7679e-3}, {3000, 1.9527e-3},
              {4800, 1.9035e-3}, {8000, 1.5617e-3}, {10000, 1.3615e-3}};
  for (const auto& row : rows) {
    EXPECT_NEAR(perturbation_velocity(paper_swimmer(row.period), rotne_prager), row.velocity, printed_digits)
        << "T = " << row.period;
  }
}

// The same source: v/A^2 and d/A of the paper's swimmer, quasi-static.
TEST(PairLawLimits, ExactMotionOfThePapersSwimmerIsTheReferenceOne) {
  constexpr double velocity_digits = 0.51e-7;
  constexpr double amplitude_digits = 1e-2;  // one of the last: 21.545 is printed as 21.55
  const struct {
    double period, velocity, d1, d2;
  } rows[] = {{1000, 1.0393e-3, 8.09, 9.60},   {2000, 1.5708e-3, 12.69, 17.11},
              {3000, 1.7397e-3, 15.21, 21.99}, {4800, 1.7021e-3, 18.11, 26.66},
              {8000, 1.4025e-3, 21.55, 29.52}, {10000, 1.2246e-3, 22.94, 30.07}};
  for (const auto& row : rows) {
    const PeriodicMotion motion = ask(paper_swimmer(row.period)).exact()->motion;
    EXPECT_NEAR(motion.velocity, row.velocity, velocity_digits) << row.period;
    EXPECT_NEAR(motion.stroke.amplitude[0], row.d1, amplitude_digits) << row.period;
    EXPECT_NEAR(motion.stroke.amplitude[1], row.d2, amplitude_digits) << row.period;
  }
}

}  // namespace
}  // namespace beadswim
