#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "beadswim/compare/comparison.hpp"

namespace beadswim {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double nan = std::numeric_limits<double>::quiet_NaN();
const std::vector<ResultQuantity> every(default_quantities.begin(), default_quantities.end());

Results swimming(double velocity, double d1, double d2, double sine) {
  return {{ResultQuantity::velocity, {{velocity}}},
          {ResultQuantity::arm_amplitudes, {{d1, d2}}},
          {ResultQuantity::sin_phase_shift, {{sine}}}};
}

Reference reference(const std::string& method, const Results& values, bool usable = true) {
  return {"p.json", method, usable, values};
}

std::vector<ComparisonRow> compare_velocity(double run, double expected, double tolerance) {
  const std::vector references{reference("rpy-ode", {{ResultQuantity::velocity, {{expected}}}})};
  return compare_swimmer({"r.json", 0, {{ResultQuantity::velocity, {{run}}}}}, references,
                         {{ResultQuantity::velocity}, tolerance, 0});
}

TEST(RootMeanSquare, WeighsValuesOfEitherSignAlike) {
  EXPECT_DOUBLE_EQ(root_mean_square(std::vector<double>{3, -4, 0, 0}), 2.5);
}

TEST(RelativeError, IsSignedAgainstTheReferencesSize) {
  const auto error = [](double run, double reference) {
    return compare_velocity(run, reference, 1).front().relative_error;
  };
  EXPECT_DOUBLE_EQ(error(11, 10), 0.1);
  EXPECT_DOUBLE_EQ(error(-11, -10), -0.1);  // more negative is below
  EXPECT_DOUBLE_EQ(error(1, -1), 2);        // swimming the other way is twice off
  EXPECT_EQ(error(0, 0), 0);
  EXPECT_EQ(error(-1e-30, 0), -infinity);
  EXPECT_TRUE(std::isnan(error(nan, 1)));
}

// Beads move by up to 0.01 in a time of 1, in a swimmer 20 long with a period of 100.
constexpr MotionScale moving{.period = 100, .length = 20, .speed = 0.01};

ComparisonRow compared(ResultQuantity quantity, double run, double expected, double numerical_error = 0) {
  Reference reference{"p.json", "rpy-ode", true, {{quantity, {{expected}}}}};
  reference.numerical_error = numerical_error;
  const RunSwimmer swimmer{.source = "r.json", .id = 0, .results = {{quantity, {{run}}}}, .scale = moving};
  return compare_swimmer(swimmer, std::vector{reference}, {{quantity}, 0.05, 0}).at(0);
}

TEST(ZeroReference, AgreesWithARunThatIsZeroWithinRoundoff) {
  for (const auto quantity : {ResultQuantity::velocity, ResultQuantity::arm_amplitudes,
                              ResultQuantity::angular_velocity, ResultQuantity::sin_phase_shift}) {
    const ComparisonRow row = compared(quantity, -1e-16, -7e-19);
    EXPECT_EQ(row.relative_error, 0);
    EXPECT_TRUE(row.pass);
  }
}

TEST(ZeroReference, GivesErrorsRelativeToWhatMoves) {
  EXPECT_DOUBLE_EQ(compared(ResultQuantity::velocity, -1e-3, 1e-16).relative_error, -(1e-3 + 1e-16) / 0.01);
  const double stroke = 0.01 * 100 / (2 * std::numbers::pi);
  EXPECT_DOUBLE_EQ(compared(ResultQuantity::arm_amplitudes, 0.01, 0).relative_error, 0.01 / stroke);
  EXPECT_DOUBLE_EQ(compared(ResultQuantity::angular_velocity, 1e-4, 0).relative_error, 1e-4 / (0.01 / 20));
  EXPECT_DOUBLE_EQ(compared(ResultQuantity::sin_phase_shift, 0.1, 0).relative_error, 0.1);
  EXPECT_FALSE(compared(ResultQuantity::velocity, 1e-3, 0).pass);
  EXPECT_TRUE(compared(ResultQuantity::velocity, 1e-4, 0).pass);
}

// A swimmer a million times slower than its beads is still compared with its own velocity, unless the
// reference states a larger numerical error.
TEST(ZeroReference, IsNotAReferenceThatIsOnlySmall) {
  EXPECT_NEAR(compared(ResultQuantity::velocity, 1.1e-8, 1e-8).relative_error, 0.1, 1e-12);
  EXPECT_FALSE(compared(ResultQuantity::velocity, 1.1e-8, 1e-8).pass);
  EXPECT_TRUE(compared(ResultQuantity::velocity, 1.1e-8, 1e-8, 2e-8).pass);
}

TEST(ZeroReference, OfAnArmHasNoPhase) {
  const Reference reference{"p.json", "rpy-ode", true, swimming(1e-5, 2, 1e-15, 0.3)};
  const RunSwimmer run{
      .source = "r.json", .id = 0, .results = swimming(1e-5, 2, 3e-15, -0.8), .scale = moving};
  const auto rows = compare_swimmer(run, std::vector{reference}, {every, 0.05, 0});
  EXPECT_EQ(rows.size(), 3U);
  EXPECT_TRUE(verdict(rows));
}

// An angle of 3.1 and one of -3.1 differ by 0.083, not by 6.2 or 200 %.
TEST(ErrorsOfAngles, AreDifferencesWithinHalfATurn) {
  const ComparisonRow row = compared(ResultQuantity::arm_phases, 3.1, -3.1);
  EXPECT_DOUBLE_EQ(row.relative_error, 6.2 - 2 * std::numbers::pi);
  EXPECT_EQ(row.arm, 1);
}

// Standard errors are relative to the same scale as the errors: a tiny reference does not make them large.
TEST(Means, AgreeWithinTwoStandardErrorsOfWhatMoves) {
  const auto row = [](double run, double expected) {
    const ResultValue mean{.numbers = {run}, .uncertainties = {0.1}, .is_mean = true};
    const std::vector references{reference("rpy-ode", {{ResultQuantity::velocity, {{expected}}}})};
    return compare_swimmer({"r.json", 0, {{ResultQuantity::velocity, mean}}, moving}, references,
                           {{ResultQuantity::velocity}, 0.01, 0})
        .front();
  };
  EXPECT_TRUE(row(11, 9).pass);  // |11 - 9| < 2 x 1.1
  EXPECT_NEAR(row(11, 9).tolerance, 2.2 / 9, 1e-12);
  EXPECT_FALSE(row(12, 9).pass);
  EXPECT_NEAR(row(1e-3, 1e-20).tolerance, 2e-4 / moving.speed, 1e-12);
  EXPECT_FALSE(row(1e-3, 1e-20).pass);
}

// A power has no scale: one that should be zero and is not has no finite error.
TEST(ZeroReference, LeavesAPowerWithoutAScale) {
  EXPECT_EQ(compared(ResultQuantity::power, 1e-9, 0).relative_error, infinity);
  EXPECT_EQ(compared(ResultQuantity::efficiency, 1e-9, 0).relative_error, infinity);
}

ComparisonRow compare_vectors(ResultQuantity quantity, const Vec3& run, const Vec3& expected) {
  const Reference reference{"p.json", "rpy-ode", true, {{quantity, {{expected.x()}, expected}}}};
  const RunSwimmer swimmer{
      .source = "r.json", .id = 0, .results = {{quantity, {{run.x()}, run}}}, .scale = moving};
  return compare_swimmer(swimmer, std::vector{reference}, {{quantity}, 0.05, 0}).at(0);
}

// A sphere that is pulled along z has no velocity along its axis, x.
TEST(ComparedVectors, DifferAcrossTheAxisToo) {
  const ComparisonRow row = compare_vectors(ResultQuantity::velocity, {0, 0, 5e-3}, {0, 0, 4e-3});
  EXPECT_DOUBLE_EQ(row.run, 5e-3);
  EXPECT_DOUBLE_EQ(row.reference, 4e-3);
  EXPECT_DOUBLE_EQ(row.relative_error, 0.25);
  EXPECT_FALSE(row.pass);
  EXPECT_FALSE(compare_vectors(ResultQuantity::velocity, {0, 0, 5e-3}, {0, 0, 0}).pass);
  EXPECT_FALSE(compare_vectors(ResultQuantity::velocity, {0, 0, 0}, {0, 0, 5e-3}).pass);
  const ComparisonRow across = compare_vectors(ResultQuantity::velocity, {-4e-3, 1e-3, 0}, {-4e-3, 0, 0});
  EXPECT_NEAR(std::abs(across.relative_error), 0.25, 1e-15);
}

// The run has turned by a right angle about z and swims as expected in its own axes.
TEST(ComparedVectors, AreThoseInTheAxesOfTheSwimmer) {
  const ResultQuantity velocity = ResultQuantity::velocity;
  Reference reference{"p.json", "rpy-ode", true, {{velocity, {{3}, Vec3(3, 0, 4)}}}};
  RunSwimmer run{.source = "r.json", .id = 0, .results = {{velocity, {{3}, Vec3(0, 3, 4)}}}, .scale = moving};
  const auto error = [&] {
    return compare_swimmer(run, std::vector{reference}, {{velocity}, 0.05, 0}).at(0).relative_error;
  };
  EXPECT_NEAR(std::abs(error()), std::sqrt(18) / 5, 1e-15);
  reference.axis = Vec3::UnitX();
  run.axis = Vec3::UnitY();
  EXPECT_NEAR(error(), 0, 1e-15);
}

TEST(ComparedVectors, KeepTheSignOfAVelocityAlongTheAxis) {
  const ComparisonRow row = compare_vectors(ResultQuantity::velocity, {-4.4e-3, 0, 0}, {-4e-3, 0, 0});
  EXPECT_DOUBLE_EQ(row.reference, -4e-3);
  EXPECT_DOUBLE_EQ(row.run, -4.4e-3);
  EXPECT_NEAR(row.relative_error, -0.1, 1e-15);
}

TEST(ComparedVectors, DifferByTheSenseOfARotation) {
  EXPECT_DOUBLE_EQ(
      compare_vectors(ResultQuantity::angular_velocity, {0, 0, -1e-4}, {0, 0, 1e-4}).relative_error, -2);
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
  const std::vector references{reference("oseen-stroke-closed", {{ResultQuantity::velocity, {{1}}}})};
  const auto rows = compare_swimmer({"r.json", 0, swimming(1, 2, 3, 0.9)}, references, {every, 0.05, 0});
  ASSERT_EQ(rows.size(), 1U);
  EXPECT_EQ(rows[0].quantity, ResultQuantity::velocity);
}

TEST(BestReference, FollowsTheOrderOfTrustAndNotOfTheFile) {
  const Results known = swimming(1, 2, 3, 0.9);
  const std::vector references{reference("oseen-force-closed", known), reference("rpy-perturbation", known),
                               reference("multipole-ode", known),
                               reference("inertia-corrected", known, false), reference("rpy-ode", known)};
  EXPECT_EQ(best_reference(references, every), 2U);
  EXPECT_EQ(best_reference(std::span(references).first(2), every), 1U);
  EXPECT_EQ(best_reference(std::span(references).first(1), every), 0U);
}

TEST(BestReference, KnowsAllThatIsAsked) {
  const std::vector references{reference("multipole-ode", {{ResultQuantity::velocity, {{1}}}}),
                               reference("oseen-force-closed", swimming(1, 2, 3, 0.9)),
                               reference("rpy-stroke-printed", swimming(1, 2, 3, 0.9), false)};
  EXPECT_EQ(best_reference(references, every), 1U);
  EXPECT_EQ(best_reference(references, std::vector{ResultQuantity::velocity}), 0U);
  EXPECT_EQ(best_reference(std::span(references).last(1), every), std::nullopt);
}

}  // namespace
}  // namespace beadswim
