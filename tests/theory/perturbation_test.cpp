#include "beadswim/theory/perturbation.hpp"

#include <gtest/gtest.h>

#include "swimmers.hpp"
#include "untruncated_closed_forms.hpp"

namespace beadswim {
namespace {

constexpr double roundoff = 1e-12;  // relative, of two 3x3 solves and sums of cancelling terms

/// Returns swimmers with equal beads and arms but unequal driving, at several separations. All terms of the
/// closed expressions then differ from zero.
std::vector<CollinearSwimmer> swimmers_of_equal_parts() {
  std::vector<CollinearSwimmer> swimmers;
  for (const double arm : {10.0, 12.0, 20.0, 80.0}) {
    for (const double phase : {std::numbers::pi / 2, -0.7, 2.9}) {
      CollinearSwimmer swimmer = paper_swimmer(2500);
      swimmer.arm = {arm, arm};
      swimmer.amplitude = {1, 0.4};
      swimmer.phase = phase;
      swimmers.push_back(swimmer);
    }
  }
  return swimmers;
}

TEST(OseenPerturbation, EqualsUntruncatedClosedExpression) {
  for (const CollinearSwimmer& swimmer : swimmers_of_equal_parts()) {
    const double closed = untruncated_velocity(swimmer, untruncated_oseen(swimmer));
    EXPECT_NEAR(perturbation_velocity(swimmer, oseen) / closed, 1, roundoff) << swimmer.arm[0];
  }
}

TEST(RotnePragerPerturbation, EqualsUntruncatedClosedExpression) {
  for (const CollinearSwimmer& swimmer : swimmers_of_equal_parts()) {
    const double closed = untruncated_velocity(swimmer, untruncated_rotne_prager(swimmer));
    EXPECT_NEAR(perturbation_velocity(swimmer, rotne_prager) / closed, 1, roundoff) << swimmer.arm[0];
  }
}

// v = C omega d1 d2 sin(delta1 - delta2) with the true stroke. Catches phases that do not belong to the
// motion.
TEST(RotnePragerPerturbation, VelocityIsGeometryFactorTimesStrokeArea) {
  for (const CollinearSwimmer& swimmer : swimmers_of_equal_parts()) {
    const SecondOrderMotion motion = second_order_motion(swimmer, rest_mobility(swimmer, rotne_prager));
    const double area =
        motion.stroke.amplitude[0] * motion.stroke.amplitude[1] * motion.stroke.sin_phase_shift();
    const double expected = untruncated_rotne_prager(swimmer).C * swimmer.angular_frequency() * area;
    EXPECT_NEAR(motion.velocity / expected, 1, roundoff);
  }
}

// The paper's relation (4.9), corrected: its lowest-order geometry factor over the untruncated one.
TEST(OseenPerturbation, ExceedsLowestOrderGeometryFactorAsInCorrectedRelation49) {
  const CollinearSwimmer swimmer = paper_swimmer(4800);
  const double l = swimmer.arm[0], a = swimmer.radius[0];
  const double relation =
      7 * std::pow(4 * l - 7 * a, 2) * (4 * l - 3 * a) / (8 * l * (56 * l * l - 198 * l * a + 189 * a * a));
  const SecondOrderMotion motion = second_order_motion(swimmer, rest_mobility(swimmer, oseen));
  const double area =
      motion.stroke.amplitude[0] * motion.stroke.amplitude[1] * motion.stroke.sin_phase_shift();
  const double lowest_order = 7 * a / (24 * l * l) * swimmer.angular_frequency() * area;
  EXPECT_NEAR(lowest_order / motion.velocity, relation, roundoff);
}

// v/A^2 of the paper's swimmer, from an independent calculation printed to five digits.
TEST(RotnePragerPerturbation, GivesReferenceVelocitiesOfThePapersSwimmer) {
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

// Oseen over Rotne-Prager from the two ratios to exact Stokes flow, each printed to three decimals.
TEST(OseenPerturbation, ExceedsRotnePragerAsTheirDistancesFromExactStokesFlowSay) {
  const struct {
    double ratio, oseen, rotne_prager;
  } rows[] = {{3, 2.258, 1.613}, {4, 1.458, 1.239},  {5, 1.234, 1.118}, {6, 1.140, 1.067},
              {8, 1.066, 1.028}, {10, 1.037, 1.014}, {20, 1.007, 1.002}};
  constexpr double printed_digits = 1e-3;
  for (const auto& row : rows) {
    CollinearSwimmer swimmer = paper_swimmer(4800);
    swimmer.arm = {row.ratio * 4, row.ratio * 4};
    const double computed =
        perturbation_velocity(swimmer, oseen) / perturbation_velocity(swimmer, rotne_prager);
    EXPECT_NEAR(computed, row.oseen / row.rotne_prager, printed_digits) << "l/lambda = " << row.ratio;
  }
}

// The three laws must agree where beads are far apart; one of wrong range would not.
TEST(RotnePragerPerturbation, AgreesWithOseenFarApart) {
  CollinearSwimmer swimmer = paper_swimmer(4800);
  swimmer.arm = {4000, 4000};
  constexpr double truncation = 2e-5;  // order (lambda/l)^2 with a factor of about 10
  EXPECT_NEAR(perturbation_velocity(swimmer, rotne_prager) / perturbation_velocity(swimmer, oseen), 1,
              truncation);
}

}  // namespace
}  // namespace beadswim
