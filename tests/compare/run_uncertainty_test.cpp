#include "beadswim/compare/run_uncertainty.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace beadswim {
namespace {

double remaining(const std::vector<double>& values) {
  return remaining_change(values).value();
}

// For changes that decrease by a constant ratio from 1/2 to 9/10, the rest of the geometric series.
TEST(RemainingChange, IsTheRestOfAGeometricSeries) {
  constexpr double limit = -3;
  for (const double ratio : {0.5, 0.7, 0.9}) {
    std::vector<double> values;
    for (int n = 0; n < 5; ++n) values.push_back(limit + std::pow(ratio, n));
    EXPECT_NEAR(remaining(values), std::pow(ratio, 4) / std::abs(values.back()), 1e-12) << ratio;
  }
}

// Faster decay, growth and changes of sign count as a ratio of 1/2: the last change remains.
TEST(RemainingChange, IsTheLastChangeUnlessChangesDecreaseSlowly) {
  EXPECT_NEAR(remaining({5, 4}), 0.25, 1e-15);
  EXPECT_NEAR(remaining({50, 5, 4}), 0.25, 1e-15);
  EXPECT_NEAR(remaining({5.1, 5, 4}), 0.25, 1e-15);
  EXPECT_NEAR(remaining({4, 5, 4}), 0.25, 1e-15);
  EXPECT_NEAR(remaining({5, 5, 4}), 0.25, 1e-15);
  EXPECT_EQ(remaining({5, 4, 4}), 0);
}

TEST(RemainingChange, GrowsForSlowDecay) {
  EXPECT_NEAR(remaining({3, 2, 1.01}), 9 * 0.99 / 1.01, 1e-12);
}

TEST(RemainingChange, IsUnknownForOneCycleAndAtRest) {
  EXPECT_FALSE(remaining_change(std::vector<double>{}));
  EXPECT_FALSE(remaining_change(std::vector<double>{4}));
  EXPECT_FALSE(remaining_change(std::vector<double>{1, 0}));
}

TEST(TotalUncertainty, IsTheRootOfTheSumOfSquaresWithoutTheBox) {
  QuantityUncertainty parts{.resolution = 0.02, .wander = 0.03, .transient = 0.06, .total = {}, .box = 5};
  EXPECT_NEAR(total_uncertainty(parts).value(), 0.07, 1e-15);
  parts.transient.reset();
  EXPECT_FALSE(total_uncertainty(parts));
}

}  // namespace
}  // namespace beadswim
