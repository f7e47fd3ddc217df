#include <gtest/gtest.h>

#include "beadswim/theory/linear_response.hpp"
#include "beadswim/theory/periodic_motion.hpp"
#include "gauge_formula.hpp"
#include "random_swimmers.hpp"

// Tests predictions of second order in the amplitude for random swimmers, by comparison with the area formula
// in long double (gauge_formula.hpp).

namespace beadswim {
namespace {

/// Largest relative errors over `count` swimmers: of the velocities and of the complex changes of the arms.
struct Errors {
  double velocity = 0, velocity_of_swing = 0, arms = 0;
};

void add_error(Errors& errors, const CollinearSwimmer& s, const PeriodicMotion& motion,
               const gauge::SecondOrder& expected) {
  const auto& x = expected.arms;
  const double swing = std::max(std::abs(x[0]), std::abs(x[1]));
  const double whole = std::abs(expected.geometry) * s.angular_frequency() * swing * swing;
  const double error = std::abs(motion.velocity - expected.velocity);
  errors.velocity = std::max(errors.velocity, error / std::abs(expected.velocity));
  errors.velocity_of_swing = std::max(errors.velocity_of_swing, error / whole);
  for (int arm = 0; arm < 2; ++arm) {
    const auto change = std::polar(motion.stroke.amplitude[arm], motion.stroke.phase[arm]);
    errors.arms = std::max(errors.arms, std::abs(change / x[arm] - 1.0));
  }
}

Errors pairwise_errors(RandomSwimmers swimmers, PairLaw law, gauge::Real size, int count) {
  constexpr gauge::Real step = 1e-3;  // of arm 1: differences of sixth order to about 1e-15
  Errors errors;
  for (int n = 0; n < count; ++n) {
    const CollinearSwimmer s = swimmers.next();
    const auto mobility = [&](gauge::Real L1, gauge::Real L2) {
      return gauge::pair_mobility(s, L1, L2, size);
    };
    add_error(errors, s, second_order_motion(s, rest_mobility(s, law)),
              gauge::second_order(s, mobility, step * s.arm[0]));
  }
  return errors;
}

constexpr double roundoff =
    1e-9;  // relative: phases within a thousandth of a reversible stroke lose 3 digits

TEST(RandomLayouts, OseenPerturbationIsTheAreaFormula) {
  const Errors errors = pairwise_errors(RandomSwimmers(1e-2, 1e2), oseen, 0, 1000);
  EXPECT_LT(errors.velocity, roundoff) << "seed " << RandomSwimmers::seed;
  EXPECT_LT(errors.arms, roundoff) << "seed " << RandomSwimmers::seed;
}

TEST(RandomLayouts, RotnePragerPerturbationIsTheAreaFormula) {
  const Errors errors = pairwise_errors(RandomSwimmers(1e-2, 1e2), rotne_prager, 1, 1000);
  EXPECT_LT(errors.velocity, roundoff) << "seed " << RandomSwimmers::seed;
  EXPECT_LT(errors.arms, roundoff) << "seed " << RandomSwimmers::seed;
}

// gamma omega/k from 1e-6 to 1e6, drawn for each arm: the velocity may be a millionth of C omega d^2, d the
// larger swing, which its error is measured by.
TEST(RandomLayouts, PerturbationHoldsFromStiffToSoftSprings) {
  const Errors errors = pairwise_errors(RandomSwimmers(1e-6, 1e6), rotne_prager, 1, 1000);
  EXPECT_LT(errors.velocity_of_swing, roundoff) << "seed " << RandomSwimmers::seed;
  EXPECT_LT(errors.arms, roundoff) << "seed " << RandomSwimmers::seed;
}

// The slopes of the exact mobility do not enter the area formula.
TEST(RandomLayouts, MultipolePerturbationIsTheAreaFormulaOfItsMobilities) {
  constexpr double truncation =
      1e-7;  // relative: differences over a fiftieth of the gap, multipoles to 1e-12
  RandomSwimmers swimmers(1e-2, 1e2);
  Errors errors;
  for (int n = 0; n < 60; ++n) {
    const CollinearSwimmer s = swimmers.next();
    const auto mobility = [&](gauge::Real L1, gauge::Real L2) {
      const LinePositions x{-static_cast<double>(L1), 0, static_cast<double>(L2)};
      return gauge::Matrix3(exact_mobility(s, x).value.cast<gauge::Real>());
    };
    const double gap = smallest_gap(s, rest_positions(s));
    add_error(errors, s, ask(s).exact()->motion, gauge::second_order(s, mobility, 0.02L * gap));
  }
  EXPECT_LT(errors.velocity, truncation) << "seed " << RandomSwimmers::seed;
  EXPECT_LT(errors.arms, truncation) << "seed " << RandomSwimmers::seed;
}

// V = C omega d_1 d_2 sin(delta_1 - delta_2) whatever drives the stroke.
TEST(RandomLayouts, VelocityOfAStrokeIsItsAreaTimesTheGeometryFactor) {
  constexpr double few_roundings = 1e-12;  // of the velocity at a shift of pi/2
  RandomSwimmers swimmers(1e-2, 1e2);
  for (int n = 0; n < 200; ++n) {
    const CollinearSwimmer s = swimmers.next();
    const CollinearMobility mobility = rest_mobility(s, rotne_prager);
    const Eigen::Vector2cd arm(std::polar(swimmers.log_uniform(0.1, 10), swimmers.uniform(-3, 3)),
                               std::polar(swimmers.log_uniform(0.1, 10), swimmers.uniform(-3, 3)));
    const double area_rate = s.angular_frequency() * std::abs(arm[0] * arm[1]);
    const double sine = std::sin(std::arg(arm[0]) - std::arg(arm[1]));
    const double C = geometry_factor(mobility);
    EXPECT_NEAR(velocity_of_stroke(arm, mobility, s.angular_frequency()) / (C * area_rate), sine,
                few_roundings)
        << "seed " << RandomSwimmers::seed;
  }
}

}  // namespace
}  // namespace beadswim
