#include "beadswim/study/optimisation.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "beadswim/core/error.hpp"

namespace beadswim {
namespace {

using testing::DoubleEq;
using testing::ElementsAre;

TEST(FreeValue, IsLogarithmicForPositiveBoundsWithARatioOfTen) {
  EXPECT_DOUBLE_EQ((FreeValue{.names = {"stiffness"}, .from = 0.01, .to = 1}).at(0.5), 0.1);
  EXPECT_DOUBLE_EQ((FreeValue{.names = {"radius"}, .from = 2, .to = 8}).at(0.5), 5);
  EXPECT_DOUBLE_EQ((FreeValue{.names = {"phase"}, .from = -1, .to = 3}).at(0.25), 0);
}

TEST(FreeValue, EqualValuesOfSeveralQuantitiesAreInTheStudy) {
  const FreeValue size{.names = {"radius", "arm"}, .from = 2, .to = 8};
  const StudyPoint point = study_point({size, {.names = {"phase"}, .from = 0, .to = 3}}, {0.5, 1});
  ASSERT_EQ(point.size(), 3U);
  EXPECT_EQ(point[0], (std::pair<std::string, Json>("radius", 5)));
  EXPECT_EQ(point[1], (std::pair<std::string, Json>("arm", 5)));
  EXPECT_EQ(point[2], (std::pair<std::string, Json>("phase", 3)));
}

Outcomes outcomes(double velocity, double power, double gap) {
  Outcomes all;
  all[ResultQuantity::velocity].value = velocity;
  all[ResultQuantity::power].value = power;
  all[ResultQuantity::gap].value = gap;
  return all;
}

// A violation is relative to its bound; for the bound 0, relative to the outcome of the first layout.
TEST(Problem, ViolationsHaveNoUnits) {
  const Problem problem{.objective = ResultQuantity::velocity,
                        .is_maximised = true,
                        .constraints = {{.outcome = ResultQuantity::power, .low = 1, .high = 4},
                                        {.outcome = ResultQuantity::gap, .low = 0}}};
  EXPECT_EQ(problem.num_inequalities(), 3);
  const Trial trial = problem.trial_of(outcomes(7, 5, -3e-6), outcomes(1, 1, 6e-6));
  EXPECT_EQ(trial.value, -7);
  EXPECT_THAT(trial.violations, ElementsAre(DoubleEq(-4), DoubleEq(0.25), DoubleEq(0.5)));
}

TEST(Problem, NamesTheOutcomeThatIsMissing) {
  const Problem problem{.objective = ResultQuantity::efficiency, .constraints = {}};
  EXPECT_THROW(problem.require_outcomes(outcomes(1, 1, 1), "rpy-ode"), InputError);
}

}  // namespace
}  // namespace beadswim
