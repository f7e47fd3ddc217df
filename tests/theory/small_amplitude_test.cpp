#include <gtest/gtest.h>

#include "beadswim/theory/periodic_motion.hpp"
#include "random_swimmers.hpp"

// Tests the limit of small amplitude: V = V_2 (1 + c s^2 + O(s^4)) for driving forces s A, s B; V_2: velocity
// to second order in s.

namespace beadswim {
namespace {

MobilityFunction pairs(const CollinearSwimmer& s, PairLaw law) {
  return [s, law](const LinePositions& x) { return pairwise_mobility(law, s.radius, x, s.viscosity); };
}

MobilityFunction exact(const CollinearSwimmer& s) {
  return [s](const LinePositions& x) { return exact_mobility(s, x); };
}

/// Returns V/V_2 - 1 of the swimmer whose arm amplitudes are at most the fraction `part` of its gaps.
double change_at(const CollinearSwimmer& swimmer, const MobilityFunction& mobility, double part) {
  const CollinearSwimmer s = driven_to(swimmer, part);
  const LinePositions rest = rest_positions(s);
  return periodic_motion(s, rest, mobility).velocity / second_order_motion(s, mobility(rest)).velocity - 1;
}

/// Checks for three amplitudes that V/V_2 - 1 decreases as amplitude^2, and is `finest` at the smallest
/// amplitude.
void expect_second_order_limit(const CollinearSwimmer& swimmer, const MobilityFunction& mobility) {
  const double coarse = change_at(swimmer, mobility, 0.04), middle = change_at(swimmer, mobility, 0.02),
               fine = change_at(swimmer, mobility, 0.01);
  constexpr double truncation = 0.01;  // of the slope: amplitude^2 beside 1
  EXPECT_NEAR(std::log2(coarse / middle), 2, truncation);
  EXPECT_NEAR(std::log2(middle / fine), 2, truncation);
  EXPECT_LT(std::abs(fine), 1e-3);
}

TEST(SmallAmplitude, FiniteMotionOfPairsTendsToSecondOrderAsAmplitudeSquared) {
  for (const CollinearSwimmer& s : {paper_swimmer(1000), paper_swimmer(4800), unequal_swimmer()}) {
    expect_second_order_limit(s, pairs(s, oseen));
    expect_second_order_limit(s, pairs(s, rotne_prager));
  }
}

TEST(SmallAmplitude, FiniteMotionOfExactMobilitiesTendsToSecondOrderAsAmplitudeSquared) {
  for (const CollinearSwimmer& s : {paper_swimmer(4800), unequal_swimmer()}) {
    expect_second_order_limit(s, exact(s));
  }
}

// Two amplitudes cancel the order beside: what is left is that of the multipoles and of amplitude^4.
TEST(SmallAmplitude, MultipoleOdeExtrapolatesToMultipolePerturbation) {
  constexpr double truncation = 1e-7;  // relative: 0.01^4 times about 5
  for (const CollinearSwimmer& s : {paper_swimmer(4800), unequal_swimmer()}) {
    const double extrapolated = (4 * change_at(s, exact(s), 0.005) - change_at(s, exact(s), 0.01)) / 3;
    EXPECT_LT(std::abs(extrapolated), truncation);
  }
}

// Stiff to soft springs, with and without dashpots. The mean change of soft arms makes the excess larger, but
// it falls with the same order.
TEST(SmallAmplitude, HoldsForStiffAndSoftSprings) {
  constexpr double truncation = 0.02;  // of the slope
  for (double gamma_omega_over_k = 1e-6; gamma_omega_over_k < 2e6; gamma_omega_over_k *= 100) {
    for (const double dashpot : {0.0, 30.0}) {
      CollinearSwimmer s = unequal_swimmer();
      const double gamma = 6 * std::numbers::pi * s.viscosity * s.radius[1];
      const double k = gamma * s.angular_frequency() / gamma_omega_over_k;
      s.stiffness = {k, 1.3 * k};
      s.damping = {dashpot * gamma, dashpot * gamma / 2};
      const double coarse = change_at(s, pairs(s, rotne_prager), 4e-4);
      const double fine = change_at(s, pairs(s, rotne_prager), 2e-4);
      EXPECT_NEAR(std::log2(coarse / fine), 2, truncation) << gamma_omega_over_k << " " << dashpot;
      EXPECT_LT(std::abs(fine), 5e-4) << gamma_omega_over_k << " " << dashpot;
    }
  }
}

// Of the paper's swimmer with Rotne-Prager pairs at A = 0.2: 0.4, 1.1, 2.9, 4.3 %, from an independent
// integration in time.
TEST(FiniteAmplitude, RotnePragerOdeHasTheReferenceChanges) {
  constexpr double printed_digits = 0.51e-3;
  const struct {
    double period, change;
  } rows[] = {{1000, 0.004}, {2000, 0.011}, {4800, 0.029}, {10000, 0.043}};
  for (const auto& row : rows) {
    CollinearSwimmer s = paper_swimmer(row.period);
    s.amplitude = {0.2, 0.2};
    const double change =
        prediction_of("rpy-ode", s).velocity / prediction_of("rpy-perturbation", s).velocity - 1;
    EXPECT_NEAR(change, row.change, printed_digits) << row.period;
  }
}

// The estimate is the leading order of the change, so it is off by some of the stroke's square.
TEST(FiniteAmplitude, EstimateIsTheChangeToLeadingOrder) {
  constexpr double model = 0.15;       // of the estimate, at 30 % of the gap: next order
  constexpr double resolution = 5e-4;  // absolute, where the change all but vanishes
  RandomSwimmers swimmers(0.05, 20);
  for (int n = 0; n < 40; ++n) {
    const CollinearSwimmer s = driven_to(swimmers.next(), 0.3);
    const double change = change_at(s, pairs(s, rotne_prager), 0.3);
    const double estimate = finite_amplitude_change(s, pairs(s, rotne_prager));
    EXPECT_NEAR(estimate, change, model * std::abs(change) + resolution) << "seed " << RandomSwimmers::seed;
  }
}

TEST(FiniteAmplitude, EstimateOfTheReferenceIsThatOfExactFlow) {
  constexpr double model = 0.08;  // of the estimate: next order
  for (const double period : {1000.0, 2000.0, 4800.0, 10000.0}) {
    CollinearSwimmer s = paper_swimmer(period);
    s.amplitude = {0.2, 0.2};
    const Question asked = ask(s);
    const double change =
        predict(find_method("multipole-ode"), asked).velocity / asked.exact()->motion.velocity - 1;
    EXPECT_NEAR(asked.exact()->amplitude_change / change, 1, model) << period;
  }
}

TEST(FiniteAmplitude, EstimateGrowsAsTheSquareOfTheDriving) {
  constexpr double roundoff = 1e-6;  // relative: a change of 1e-4 of a velocity known to 1e-11
  const CollinearSwimmer weak = driven_to(unequal_swimmer(), 0.1), strong = driven_to(unequal_swimmer(), 0.4);
  EXPECT_NEAR(finite_amplitude_change(strong, pairs(strong, rotne_prager)) /
                  finite_amplitude_change(weak, pairs(weak, rotne_prager)),
              16, 16 * roundoff);
}

TEST(FiniteAmplitude, EstimateIsZeroWhereNothingMovesAndNotANumberForOverlap) {
  CollinearSwimmer s = paper_swimmer(4800);
  s.phase = 0;
  EXPECT_EQ(finite_amplitude_change(s, pairs(s, rotne_prager)), 0);
  s.amplitude = {0, 0};
  EXPECT_EQ(finite_amplitude_change(s, pairs(s, rotne_prager)), 0);
  s.arm = {7, 20};
  EXPECT_TRUE(std::isnan(finite_amplitude_change(s, pairs(s, rotne_prager))));
}

}  // namespace
}  // namespace beadswim
