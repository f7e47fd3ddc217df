#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "beadswim/compare/comparison.hpp"

namespace beadswim {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double nan = std::numeric_limits<double>::quiet_NaN();
const std::vector<ComparedQuantity> every(default_quantities.begin(), default_quantities.end());

ComparedValues swimming(double velocity, double d1, double d2, double sine) {
  return {{ComparedQuantity::velocity, {velocity}},
          {ComparedQuantity::arm_amplitudes, {d1, d2}},
          {ComparedQuantity::sin_phase_shift, {sine}}};
}

Reference reference(const std::string& method, const ComparedValues& values, bool usable = true) {
  return {"p.json", method, usable, values};
}

std::vector<ComparisonRow> compare_velocity(double run, double expected, double tolerance) {
  const std::vector references{reference("rpy-ode", {{ComparedQuantity::velocity, {expected}}})};
  return compare_swimmer({"r.json", 0, {{ComparedQuantity::velocity, {run}}}}, references,
                         {{ComparedQuantity::velocity}, tolerance, 0});
}

TEST(RootMeanSquare, WeighsValuesOfEitherSignAlike) {
  EXPECT_DOUBLE_EQ(root_mean_square(std::vector<double>{3, -4, 0, 0}), 2.5);
}

TEST(RelativeError, IsSignedAgainstTheReferencesSize) {
  EXPECT_DOUBLE_EQ(relative_error(11, 10), 0.1);
  EXPECT_DOUBLE_EQ(relative_error(-11, -10), -0.1);  // more negative is below
  EXPECT_DOUBLE_EQ(relative_error(1, -1), 2);        // swimming the other way is twice off
  EXPECT_EQ(relative_error(0, 0), 0);
  EXPECT_EQ(relative_error(-1e-30, 0), -infinity);
  EXPECT_TRUE(std::isnan(relative_error(nan, 1)));
}

TEST(Verdict, PassesAtTheToleranceAndFailsBeyondIt) {
  EXPECT_TRUE(verdict(compare_velocity(1.25, 1, 0.25)));
  EXPECT_TRUE(verdict(compare_velocity(0.75, 1, 0.25)));
  EXPECT_FALSE(verdict(compare_velocity(std::nextafter(1.25, 2), 1, 0.25)));
  EXPECT_FALSE(verdict(compare_velocity(std::nextafter(0.75, 0), 1, 0.25)));
  EXPECT_FALSE(verdict(compare_velocity(-1, 1, 0.25)));
}

TEST(Verdict, NeverPassesWhatIsNotANumber) {
  EXPECT_FALSE(verdict(compare_velocity(nan, 1, infinity)));
  EXPECT_FALSE(verdict(compare_velocity(1, nan, infinity)));
  EXPECT_FALSE(verdict(compare_velocity(1, 0, 1e300)));
}

TEST(Verdict, NeedsARowThatDecides) {
  EXPECT_FALSE(verdict({}));
  std::vector<ComparisonRow> rows = compare_velocity(1, 1, 0.1);
  rows[0].decides = false;
  EXPECT_FALSE(verdict(rows));
}

TEST(Comparison, OnlyTheDecidingReferenceDecides) {
  const std::vector references{reference("multipole-ode", swimming(1, 2, 3, 0.9)),
                               reference("oseen-force-closed", swimming(100, 100, 100, 100))};
  const auto rows = compare_swimmer({"r.json", 7, swimming(1, 2, 3, 0.9)}, references, {every, 0.05, 0});
  ASSERT_EQ(rows.size(), 8U);
  for (const ComparisonRow& row : rows) {
    EXPECT_EQ(row.decides, row.method == "multipole-ode");
    EXPECT_EQ(row.pass, row.method == "multipole-ode");
    EXPECT_EQ(row.swimmer, 7);
  }
  EXPECT_TRUE(verdict(rows));
}

TEST(Comparison, AnUnusableReferenceNeverDecides) {
  const std::vector references{reference("rpy-force-printed", swimming(1, 2, 3, 0.9), false)};
  const auto rows = compare_swimmer({"r.json", 0, swimming(1, 2, 3, 0.9)}, references, {every, 0.05, 0});
  EXPECT_FALSE(rows.empty());
  for (const ComparisonRow& row : rows) EXPECT_FALSE(row.decides);
  EXPECT_FALSE(verdict(rows));
}

TEST(Comparison, OneArmThatIsOffMakesTheVerdictNegative) {
  const std::vector references{reference("rpy-ode", swimming(1, 2, 3, 0.9))};
  const auto rows = compare_swimmer({"r.json", 0, swimming(1, 2, 3.5, 0.9)}, references, {every, 0.05, 0});
  EXPECT_FALSE(verdict(rows));
  ASSERT_EQ(rows.size(), 4U);
  EXPECT_EQ(rows[1].arm, 1);
  EXPECT_TRUE(rows[1].pass);
  EXPECT_EQ(rows[2].arm, 2);
  EXPECT_FALSE(rows[2].pass);
}

TEST(Comparison, LeavesOutWhatAReferenceDoesNotKnow) {
  const std::vector references{reference("oseen-stroke-closed", {{ComparedQuantity::velocity, {1}}})};
  const auto rows = compare_swimmer({"r.json", 0, swimming(1, 2, 3, 0.9)}, references, {every, 0.05, 0});
  ASSERT_EQ(rows.size(), 1U);
  EXPECT_EQ(rows[0].quantity, ComparedQuantity::velocity);
}

TEST(BestReference, FollowsTheOrderOfTrustAndNotOfTheFile) {
  const ComparedValues known = swimming(1, 2, 3, 0.9);
  const std::vector references{reference("oseen-force-closed", known), reference("rpy-perturbation", known),
                               reference("multipole-ode", known),
                               reference("inertia-corrected", known, false), reference("rpy-ode", known)};
  EXPECT_EQ(best_reference(references, every), 2U);
  EXPECT_EQ(best_reference(std::span(references).first(2), every), 1U);
  EXPECT_EQ(best_reference(std::span(references).first(1), every), 0U);
}

TEST(BestReference, KnowsAllThatIsAsked) {
  const std::vector references{reference("multipole-ode", {{ComparedQuantity::velocity, {1}}}),
                               reference("oseen-force-closed", swimming(1, 2, 3, 0.9)),
                               reference("rpy-stroke-printed", swimming(1, 2, 3, 0.9), false)};
  EXPECT_EQ(best_reference(references, every), 1U);
  EXPECT_EQ(best_reference(references, std::vector{ComparedQuantity::velocity}), 0U);
  EXPECT_EQ(best_reference(std::span(references).last(1), every), std::nullopt);
}

}  // namespace
}  // namespace beadswim
