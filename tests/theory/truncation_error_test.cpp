#include "beadswim/theory/truncation_error.hpp"

#include <gtest/gtest.h>

#include "beadswim/theory/linear_response.hpp"
#include "swimmers.hpp"

namespace beadswim {
namespace {

TEST(TruncationError, InterpolatesTheReferencesAndFallsBeyondThem) {
  constexpr double roundoff = 1e-14;
  EXPECT_NEAR(*rotne_prager_over_exact(3), 1.613, roundoff);
  EXPECT_NEAR(*rotne_prager_over_exact(5), 1.118, roundoff);
  EXPECT_NEAR(*rotne_prager_over_exact(20), 1.002, roundoff);
  EXPECT_GT(*rotne_prager_over_exact(4.5), *rotne_prager_over_exact(5));
  EXPECT_LT(*rotne_prager_over_exact(40) - 1, 0.002 / 4);
}

TEST(TruncationError, IsUnknownForNearerBeadsThanItsReferences) {
  EXPECT_FALSE(rotne_prager_over_exact(2.99).has_value());
}

// The estimate of exact Stokes flow (Rotne-Prager velocity over its excess, taken at T = 4800) against exact
// velocities of the paper's swimmer over a tenfold range of periods.
TEST(TruncationError, EstimatesExactVelocityAtAllPeriods) {
  constexpr double model = 0.011;  // the excess goes from 12.9 to 11.2 % over these periods
  const struct {
    double period, exact;
  } rows[] = {{1000, 1.0393e-3}, {2000, 1.5708e-3}, {3000, 1.7397e-3},
              {4800, 1.7021e-3}, {8000, 1.4025e-3}, {10000, 1.2246e-3}};
  for (const auto& row : rows) {
    const double estimate =
        perturbation_velocity(paper_swimmer(row.period), rotne_prager) / *rotne_prager_over_exact(5);
    EXPECT_NEAR(estimate / row.exact, 1, model) << row.period;
  }
}

// Change of the velocity at A = 0.2 from finite-amplitude integration: 0.4, 1.1, 2.9, 4.3 %.
TEST(TruncationError, EstimatesFiniteAmplitudeChange) {
  constexpr double model = 0.003;  // absolute: a fit of one coefficient
  const struct {
    double period, change;
  } rows[] = {{1000, 0.004}, {2000, 0.011}, {4800, 0.029}, {10000, 0.043}};
  for (const auto& row : rows) {
    CollinearSwimmer swimmer = paper_swimmer(row.period);
    swimmer.amplitude = {0.2, 0.2};
    const Stroke stroke = first_order_stroke(swimmer, rotne_prager);
    EXPECT_NEAR(finite_amplitude_change(swimmer, stroke.amplitude), row.change, model) << row.period;
  }
}

TEST(TruncationError, SeparationIsTheNearestPairsOverItsMeanRadius) {
  CollinearSwimmer swimmer = paper_swimmer(4800);
  EXPECT_EQ(separation_ratio(swimmer), 5);
  swimmer.radius = {4, 6, 4};
  swimmer.arm = {30, 20};
  EXPECT_EQ(separation_ratio(swimmer), 4);
}

}  // namespace
}  // namespace beadswim
