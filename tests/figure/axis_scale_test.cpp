#include <gtest/gtest.h>

#include <cmath>

#include "beadswim/figure/axis_scale.hpp"
#include "tolerances.hpp"

namespace beadswim {
namespace {

std::vector<std::string> labels(const AxisScale& scale) {
  std::vector<std::string> result;
  for (const Tick& tick : scale.ticks) result.push_back(tick.label);
  return result;
}

TEST(AxisScale, TicksAreRoundNumbersWithinTheAxis) {
  EXPECT_EQ(labels(linear_scale(0, 1, TickKind::any)),
            (std::vector<std::string>{"0.0", "0.2", "0.4", "0.6", "0.8", "1.0"}));
  EXPECT_EQ(labels(linear_scale(3.4, 5.6, TickKind::any)),
            (std::vector<std::string>{"3.5", "4.0", "4.5", "5.0", "5.5"}));
  EXPECT_EQ(labels(linear_scale(-0.02, 0.02, TickKind::any)),
            (std::vector<std::string>{"-0.02", "-0.01", "0.00", "0.01", "0.02"}));
}

TEST(AxisScale, DataLieInsideTheAxis) {
  const AxisScale scale = linear_scale(1000, 10000, TickKind::any);
  EXPECT_GT(scale.fraction(1000), 0);
  EXPECT_LT(scale.fraction(10000), 1);
  EXPECT_NEAR(scale.fraction(5500), 0.5, roundoff(10));
}

// Velocities are of order 1e-5: their power of ten goes to the axis label.
TEST(AxisScale, SmallNumbersShareAPowerOfTen) {
  const AxisScale scale = linear_scale(6.1e-5, 7.4e-5, TickKind::any);
  EXPECT_EQ(scale.exponent, -5);
  EXPECT_EQ(labels(scale), (std::vector<std::string>{"6.2", "6.4", "6.6", "6.8", "7.0", "7.2", "7.4"}));
}

TEST(AxisScale, OneValueAloneGetsRoom) {
  for (const double value : {-3e-5, 0.0, 4800.0}) {
    const AxisScale scale = linear_scale(value, value, TickKind::any);
    EXPECT_LT(scale.low, value);
    EXPECT_GT(scale.high, value);
    EXPECT_GE(scale.ticks.size(), 2U) << value;
  }
}

TEST(AxisScale, CyclesAreWhole) {
  EXPECT_EQ(labels(linear_scale(0.5, 2.5, TickKind::integers)), (std::vector<std::string>{"1", "2"}));
  EXPECT_EQ(labels(linear_scale(0.5, 40.5, TickKind::integers)),
            (std::vector<std::string>{"0", "5", "10", "15", "20", "25", "30", "35", "40"}));
  EXPECT_EQ(labels(linear_scale(0.5, 6.5, TickKind::integers)),
            (std::vector<std::string>{"1", "2", "3", "4", "5", "6"}));
}

// Equal ratios are equal lengths; would catch a scale that is logarithmic in its ticks alone.
TEST(LogarithmicScale, EqualRatiosAreEqualLengths) {
  const AxisScale scale = logarithmic_scale(1e-7, 1e-4);
  const double decade = scale.fraction(1e-5) - scale.fraction(1e-6);
  EXPECT_NEAR(scale.fraction(1e-4) - scale.fraction(1e-5), decade, roundoff(10));
  EXPECT_NEAR(scale.fraction(3e-6) - scale.fraction(3e-7), decade, roundoff(10));
  EXPECT_GT(scale.fraction(1e-7), 0);
  EXPECT_LT(scale.fraction(1e-4), 1);
}

TEST(LogarithmicScale, DecadesAreLabelledAsPowers) {
  const AxisScale scale = logarithmic_scale(2e-7, 2e-4);
  EXPECT_EQ(labels(scale), (std::vector<std::string>{"10⁻⁶", "10⁻⁵", "10⁻⁴"}));
  EXPECT_EQ(scale.exponent, 0);
}

TEST(LogarithmicScale, OneDecadeIsLabelledInDigits) {
  const AxisScale plain = logarithmic_scale(3, 30);
  EXPECT_EQ(labels(plain), (std::vector<std::string>{"3", "5", "10", "20", "30"}));
  const AxisScale small = logarithmic_scale(1.5e-6, 2.5e-5);
  EXPECT_EQ(small.exponent, -6);
  EXPECT_EQ(labels(small), (std::vector<std::string>{"2", "3", "5", "10", "20"}));
}

TEST(LogarithmicScale, LessThanADecadeHasRoundTicks) {
  EXPECT_EQ(labels(logarithmic_scale(1.9, 4.1)),
            (std::vector<std::string>{"2.0", "2.5", "3.0", "3.5", "4.0"}));
  EXPECT_GE(logarithmic_scale(5, 5).ticks.size(), 2U);
}

TEST(LogarithmicScale, HasNoPlaceForWhatIsNotPositive) {
  EXPECT_FALSE(std::isfinite(logarithmic_scale(1, 10).fraction(0)));
  EXPECT_FALSE(std::isfinite(logarithmic_scale(1, 10).fraction(-1)));
}

}  // namespace
}  // namespace beadswim
