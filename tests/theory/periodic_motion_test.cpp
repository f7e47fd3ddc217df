#include "beadswim/theory/periodic_motion.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "beadswim/core/error.hpp"
#include "gauge_formula.hpp"
#include "random_swimmers.hpp"
#include "time_integration.hpp"

// Tests the harmonic-balance solution by integration in time, which uses neither harmonics nor derivatives of
// the mobility.

namespace beadswim {
namespace {

using Real = timestepping::Real;

MobilityFunction pairs(const CollinearSwimmer& s, PairLaw law) {
  return [s, law](const LinePositions& x) { return pairwise_mobility(law, s.radius, x, s.viscosity); };
}

std::array<double, 2> mean_arms(const CollinearSwimmer& s, const PeriodicMotion& motion) {
  return {s.arm[0] + motion.arm_changes[0], s.arm[1] + motion.arm_changes[1]};
}

/// Returns the arm lengths at t = 0, as initial guess for the shooting method.
timestepping::Vector2 arms_at_start(const CollinearSwimmer& s, const PeriodicMotion& motion) {
  timestepping::Vector2 arms;
  for (int arm = 0; arm < 2; ++arm) {
    arms[arm] = mean_arms(s, motion)[arm] + motion.stroke.amplitude[arm] * std::cos(motion.stroke.phase[arm]);
  }
  return arms;
}

/// Returns the error of V divided by max(|V|, 1e-6 omega d), d: larger arm amplitude.
double relative_error(const CollinearSwimmer& s, const PeriodicMotion& motion, double expected) {
  const double swing = std::max(motion.stroke.amplitude[0], motion.stroke.amplitude[1]);
  const double least = 1e-6 * s.angular_frequency() * swing;
  return std::abs(motion.velocity - expected) / std::max(std::abs(expected), least);
}

constexpr int large_steps = 48;  // a period; twice as many change V by less than 1e-10
constexpr double nine_digits = 1e-9;

template <class Mobility>
void expect_the_integrated_motion(const CollinearSwimmer& s, const PeriodicMotion& motion,
                                  const Mobility& mobility) {
  const timestepping::Motion expected =
      timestepping::periodic(s, mobility, arms_at_start(s, motion), large_steps);
  EXPECT_LT(relative_error(s, motion, expected.velocity), nine_digits);
  for (int arm = 0; arm < 2; ++arm) {
    EXPECT_NEAR(mean_arms(s, motion)[arm] / expected.arm_means[arm], 1, nine_digits);
  }
}

void expect_the_integrated_motions_of_pairs(PairLaw law, Real size) {
  RandomSwimmers swimmers(0.2, 20);
  for (int n = 0; n < 30; ++n) {
    SCOPED_TRACE(testing::Message() << "swimmer " << n << ", seed " << RandomSwimmers::seed);
    CollinearSwimmer s = swimmers.next();
    s = driven_to(s, n == 0 ? 0.6 : swimmers.log_uniform(0.01, 0.6));
    const auto mobility = [&](Real L1, Real L2) { return gauge::pair_mobility(s, L1, L2, size); };
    expect_the_integrated_motion(s, periodic_motion(s, rest_positions(s), pairs(s, law)), mobility);
  }
}

TEST(HarmonicBalance, OfOseenPairsIsTheMotionIntegratedInTime) {
  expect_the_integrated_motions_of_pairs(oseen, 0);
}

TEST(HarmonicBalance, OfRotnePragerPairsIsTheMotionIntegratedInTime) {
  expect_the_integrated_motions_of_pairs(rotne_prager, 1);
}

// Phases of a millionth and equal parts: all but reversible, V a millionth of its usual size.
TEST(HarmonicBalance, KeepsItsDigitsForAllButReversibleDriving) {
  for (const double phase : {1e-3, 1e-6}) {
    CollinearSwimmer s = paper_swimmer(4800);
    s.phase = phase;
    s = driven_to(s, 0.4);
    const auto mobility = [&](Real L1, Real L2) { return gauge::pair_mobility(s, L1, L2, 1); };
    expect_the_integrated_motion(s, periodic_motion(s, rest_positions(s), pairs(s, rotne_prager)), mobility);
  }
}

// 60 % of the gap takes more harmonics than 1 %: the motion with few and with many is equally right (above).
TEST(HarmonicBalance, TakesMoreHarmonicsForLargerStrokes) {
  const CollinearSwimmer gentle = driven_to(paper_swimmer(4800), 0.01);
  const CollinearSwimmer strong = driven_to(paper_swimmer(4800), 0.85);
  const auto nodes = [](const CollinearSwimmer& s) {
    return periodic_motion(s, rest_positions(s), pairs(s, rotne_prager)).samples;
  };
  EXPECT_GT(nodes(strong), nodes(gentle));
}

/// Exact mobility, interpolated by Chebyshev polynomials in both arm lengths.
class ChebyshevMobility {
 public:
  ChebyshevMobility(const CollinearSwimmer& s, const std::array<double, 2>& middle, double half_width)
      : middle_(middle), half_width_(half_width) {
    for (int i = 0; i < points; ++i) {
      for (int j = 0; j < points; ++j) {
        const double L1 = middle[0] + half_width * node(i), L2 = middle[1] + half_width * node(j);
        values_[i][j] = exact_mobility(s, {-L1, 0, L2}).value.cast<Real>();
      }
    }
  }

  timestepping::Matrix3 operator()(Real L1, Real L2) const {
    const Weights a = weights((L1 - middle_[0]) / half_width_), b = weights((L2 - middle_[1]) / half_width_);
    timestepping::Matrix3 sum = timestepping::Matrix3::Zero();
    for (int i = 0; i < points; ++i) {
      for (int j = 0; j < points; ++j) sum += a[i] * b[j] * values_[i][j];
    }
    return sum;
  }

 private:
  static constexpr int points = 20;
  using Weights = std::array<Real, points>;

  static double node(int i) { return std::cos(std::numbers::pi * (i + 0.5) / points); }

  /// Returns the barycentric weights of the Chebyshev points of the first kind.
  static Weights weights(Real t) {
    Weights w;
    Real sum = 0;
    for (int i = 0; i < points; ++i) {
      const Real sign = i % 2 == 0 ? 1 : -1;
      w[i] = sign * std::sin(std::numbers::pi_v<Real> * (i + 0.5L) / points) / (t - node(i));
      sum += w[i];
    }
    for (Real& weight : w) weight /= sum;
    return w;
  }

  std::array<double, 2> middle_;
  double half_width_;
  std::array<std::array<timestepping::Matrix3, points>, points> values_;
};

TEST(HarmonicBalance, OfExactMobilitiesIsTheMotionIntegratedInTime) {
  for (CollinearSwimmer s : {paper_swimmer(4800), unequal_swimmer()}) {
    s = driven_to(s, 0.4);
    const MobilityFunction mobility = [&](const LinePositions& x) { return exact_mobility(s, x); };
    const PeriodicMotion motion = periodic_motion(s, rest_positions(s), mobility);
    const double swing = std::max(motion.stroke.amplitude[0], motion.stroke.amplitude[1]);
    expect_the_integrated_motion(s, motion, ChebyshevMobility(s, mean_arms(s, motion), 1.2 * swing));
  }
}

std::string refusal_of(const CollinearSwimmer& s) {
  try {
    periodic_motion(s, rest_positions(s), pairs(s, rotne_prager));
    return "";
  } catch (const InputError& error) {
    return error.what();
  }
}

// Gaps of 12; arm 2 would swing by 26.7 A. The message says how far the driving can go.
TEST(HarmonicBalance, RefusesContactAndSaysHowFarTheDrivingCanBeTurnedUp) {
  CollinearSwimmer s = paper_swimmer(4800);
  s.amplitude = {1, 1};
  EXPECT_THAT(refusal_of(s), testing::ContainsRegex("exceeds about 0\\.[0-9]+ times the given amplitude"));
  s.amplitude = {0.4, 0.4};
  EXPECT_EQ(refusal_of(s), "");
}

TEST(HarmonicBalance, SmallestGapIsThatOfTheMotion) {
  const CollinearSwimmer s = driven_to(paper_swimmer(4800), 0.3);
  const PeriodicMotion motion = periodic_motion(s, rest_positions(s), pairs(s, rotne_prager));
  constexpr double model = 0.02;  // of the gap at rest: nodes beside the closest approach, second harmonics
  EXPECT_NEAR(motion.smallest_gap / 12, 0.7, model);
}

}  // namespace
}  // namespace beadswim
