#include "beadswim/study/search.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace beadswim {
namespace {

using std::numbers::pi;

Trial free_trial(double value) {
  return {.value = value, .violations = {}};
}

TEST(Search, FindsTheLowestOfManyMinimaOfOneNumber) {
  // Sum of a parabola around 0.7 and waves of the period 0.1 with a crest at 0.75; the lowest minimum is near
  // 0.7.
  const auto waves = [](double x) { return 4 * (x - 0.7) * (x - 0.7) - 0.5 * std::cos(20 * pi * (x - 0.7)); };
  const SearchResult found =
      search(1, [&](const Position& x) { return free_trial(waves(x[0])); }, {.evaluations = 100});
  EXPECT_NEAR(found.best[0], 0.7, 1e-4);
  EXPECT_LE(found.evaluations, 100);
}

/// Branin's function of Dixon and Szegoe (1978) on [-5, 10] x [0, 15]; its three minima are 0.397887.
double branin(const Position& u) {
  const double x = -5 + 15 * u[0], y = 15 * u[1];
  const double a = y - 5.1 / (4 * pi * pi) * x * x + 5 / pi * x - 6;
  return a * a + 10 * (1 - 1 / (8 * pi)) * std::cos(x) + 10;
}

TEST(Search, FindsBraninsMinimum) {
  const SearchResult found =
      search(2, [](const Position& u) { return free_trial(branin(u)); }, {.evaluations = 200});
  EXPECT_NEAR(*found.trial.value, 0.3978873577, 1e-7);
}

TEST(Search, ReachesTheLimitOfAConstraint) {
  // The product x y under x^2 + y^2 <= c is greatest at x = y = sqrt(c/2), here beside the first positions.
  constexpr double c = 0.6;
  const auto product = [](const Position& u) {
    return Trial{.value = -u[0] * u[1], .violations = {(u[0] * u[0] + u[1] * u[1] - c) / c}};
  };
  const SearchResult found = search(2, product, {.num_inequalities = 1, .evaluations = 200});
  EXPECT_TRUE(found.trial.is_feasible());
  EXPECT_NEAR(*found.trial.value, -c / 2, 1e-5);
  EXPECT_NEAR(found.best[0], std::sqrt(c / 2), 2e-3);
  EXPECT_LE(found.trial.max_violation(), 0);
}

TEST(Search, FindsAnOptimumBesidePositionsWithoutAValue) {
  const auto cut = [](const Position& u) {
    if (u[0] < 0.3 || u[1] > 0.8) return Trial{};
    return free_trial(std::pow(u[0] - 0.2, 2) + std::pow(u[1] - 0.4, 2));
  };
  const SearchResult found = search(2, cut, {.evaluations = 200});
  EXPECT_NEAR(found.best[0], 0.3, 2e-3);
  EXPECT_NEAR(found.best[1], 0.4, 2e-3);
}

/// Sphere with waves in five dimensions; the lowest of its many minima is 0 at 0.3.
double many_minima(const Position& u) {
  double sum = 0;
  for (const double x : u) sum += 10 * (x - 0.3) * (x - 0.3) + 0.1 * (1 - std::cos(12 * pi * (x - 0.3)));
  return sum;
}

TEST(Search, FindsTheLowestMinimumOfFiveNumbersWithTheSamePathForTheSameSeed) {
  std::vector<Position> path, again;
  const auto along = [](std::vector<Position>& positions) {
    return [&positions](const Position& u) {
      positions.push_back(u);
      return free_trial(many_minima(u));
    };
  };
  const SearchResult found = search(5, along(path), {.evaluations = 4000, .seed = 7});
  EXPECT_NEAR(*found.trial.value, 0, 1e-6);
  search(5, along(again), {.evaluations = 4000, .seed = 7});
  EXPECT_EQ(path, again);
}

TEST(Search, PassesOnTheExceptionsOfTheFunction) {
  struct Stop {};
  int calls = 0;
  const auto stopping = [&](const Position& u) {
    if (++calls == 7) throw Stop();
    return free_trial(u[0]);
  };
  EXPECT_THROW(search(1, stopping, {.evaluations = 60}), Stop);
  EXPECT_EQ(calls, 7);
}

TEST(Search, SaysIfNoPositionIsFeasible) {
  const auto never = [](const Position& u) { return Trial{.value = u[0], .violations = {1 + u[0]}}; };
  const SearchResult found = search(1, never, {.num_inequalities = 1, .evaluations = 60});
  EXPECT_FALSE(found.trial.is_feasible());
  EXPECT_NEAR(found.trial.max_violation(), 1, 1e-3);
}

TEST(FlatRange, EndsWhereTheFunctionHasGrownByItsShare) {
  // -1 + 4 (x - 0.4)^2 grows by 1 % within 0.05.
  const EvaluateTrial well = [](const Position& u) {
    return Trial{.value = -1 + 4 * std::pow(u[0] - 0.4, 2), .violations = {u[0] - 0.43}};
  };
  const EvaluateTrial free = [&](const Position& u) { return free_trial(*well(u).value); };
  const SearchResult best{.best = {0.4}, .trial = free_trial(-1), .evaluations = 1};
  const auto [low, high] = flat_range(best, 0, 0.01, free);
  EXPECT_GE(low, 0.35);
  EXPECT_NEAR(low, 0.35, 0.0016);
  EXPECT_LE(high, 0.45);
  EXPECT_NEAR(high, 0.45, 0.0016);
  EXPECT_NEAR(flat_range(best, 0, 0.01, well).second, 0.43, 0.001) << "at the limit of the constraint";
  const auto [zero, one] = flat_range(best, 0, 2, free);
  EXPECT_EQ(zero, 0);
  EXPECT_EQ(one, 1);
}

}  // namespace
}  // namespace beadswim
