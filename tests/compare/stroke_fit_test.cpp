#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include "beadswim/compare/stroke_fit.hpp"
#include "beadswim/core/error.hpp"
#include "tolerances.hpp"

namespace beadswim {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double period = 4800;  // [time steps]
constexpr double angular_frequency = 2 * pi / period;
constexpr double mean = 20, amplitude = 3.5;  // [cells], of the size of the single swimmer's stroke

std::vector<double> uniform_times(int n, double start = 0) {
  std::vector<double> times;
  for (int i = 0; i < n; ++i) times.push_back(start + period * i / n);
  return times;
}

/// Returns n random times within one period, in ascending order. The seed makes them reproducible.
std::vector<double> scattered_times(int n, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> anywhere(0, period);
  std::vector<double> times;
  for (int i = 0; i < n; ++i) times.push_back(anywhere(random));
  std::sort(times.begin(), times.end());
  return times;
}

/// Returns the arm lengths mean + amplitude cos(w t + phase) + second cos(2 w t + 0.4) at these times.
std::vector<double> lengths_at(const std::vector<double>& times, double phase, double second = 0) {
  std::vector<double> lengths;
  for (const double t : times) {
    const double angle = angular_frequency * t;
    lengths.push_back(mean + amplitude * std::cos(angle + phase) + second * std::cos(2 * angle + 0.4));
  }
  return lengths;
}

StrokeFit fit(const std::vector<double>& times, const std::vector<double>& lengths) {
  return fit_stroke(times, lengths, angular_frequency);
}

// Would catch sin and cos swapped, delta's sign, and a phase that leaves its quadrant.
TEST(StrokeFit, RecoversAPureStrokeInEveryQuadrant) {
  for (const double phase : {-3.0, -1.6, -0.5, 0.0, 0.5, 1.6, 3.0}) {
    const auto times = uniform_times(40);
    const StrokeFit stroke = fit(times, lengths_at(times, phase));
    EXPECT_NEAR(stroke.mean, mean, mean * roundoff(50));
    EXPECT_NEAR(stroke.amplitude, amplitude, mean * roundoff(50));
    EXPECT_NEAR(stroke.phase, phase, mean / amplitude * roundoff(50)) << "phase " << phase;
  }
}

// Would catch a Fourier sum in place of least squares: it is wrong on scattered times.
TEST(StrokeFit, RecoversAPureStrokeFromScatteredTimes) {
  constexpr unsigned seed = 7;
  SCOPED_TRACE(testing::Message() << "seed " << seed);
  const auto times = scattered_times(25, seed);
  const StrokeFit stroke = fit(times, lengths_at(times, 1.2));
  EXPECT_NEAR(stroke.mean, mean, mean * roundoff(500));
  EXPECT_NEAR(stroke.amplitude, amplitude, mean * roundoff(500));
  EXPECT_NEAR(stroke.phase, 1.2, mean / amplitude * roundoff(500));
}

TEST(StrokeFit, IsBlindToTheSecondHarmonicOnUniformSamples) {
  for (const int n : {4, 10, 40}) {
    const auto times = uniform_times(n);
    const StrokeFit stroke = fit(times, lengths_at(times, -0.7, 0.5));
    // At n = 4 the second harmonic alternates in sign: orthogonal to the first, and to the mean.
    EXPECT_NEAR(stroke.amplitude, amplitude, mean * roundoff(50)) << n << " samples";
    EXPECT_NEAR(stroke.phase, -0.7, mean / amplitude * roundoff(50)) << n << " samples";
  }
}

// Would catch times counted from the cycle's start: the phase belongs to the driving's clock.
TEST(StrokeFit, PhaseIsOnTheClockOfTheDriving) {
  const double late = 5 * period + period / 3;
  const auto times = uniform_times(40, late);
  EXPECT_NEAR(fit(times, lengths_at(times, 0.9)).phase, 0.9, mean / amplitude * roundoff(500));
}

// Would catch atan2's -pi: roundoff puts some of these sine parts just above zero.
TEST(StrokeFit, PhaseOfHalfATurnIsPlusPi) {
  for (int n = 4; n <= 60; ++n) {
    const auto times = uniform_times(n);
    const double phase = fit(times, lengths_at(times, pi)).phase;
    EXPECT_NEAR(std::abs(phase), pi, mean / amplitude * roundoff(50));
    EXPECT_GT(phase, -pi) << n << " samples";
  }
}

// Would catch atan2 of two negative zeros, which is -pi.
TEST(StrokeFit, AnArmAtRestHasNoAmplitudeAndPhaseZero) {
  for (const double length : {0.0, -0.0}) {
    const StrokeFit stroke = fit(uniform_times(4), std::vector<double>(4, length));
    EXPECT_EQ(stroke.amplitude, 0);
    EXPECT_EQ(stroke.phase, 0);
  }
}

TEST(StrokeFit, RefusesSamplesThatDoNotDetermineTheStroke) {
  EXPECT_THROW(fit({0, 1600}, {20, 21}), InputError);
  EXPECT_THROW(fit({0, 1600, 3200}, {20, 21}), InputError);
  EXPECT_THROW(fit({0, 0, 0, 0}, {20, 20, 20, 20}), InputError);
  EXPECT_THROW(fit({0, period / 2, period, 1.5 * period}, {20, 21, 20, 21}), InputError);
}

}  // namespace
}  // namespace beadswim
