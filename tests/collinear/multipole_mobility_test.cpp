#include "beadswim/collinear/multipole_mobility.hpp"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <random>

#include "beadswim/collinear/rotne_prager.hpp"
#include "beadswim/core/error.hpp"
#include "bispherical.hpp"

namespace beadswim {
namespace {

using Numbers = std::vector<double>;

constexpr double eta = 1.0 / 3;  // [mass/(length time)]

/// Mobilities of two equal spheres of radius 4 at a distance of s radii, divided by the mobility of a single
/// sphere.
struct EqualPair {
  double self, pair;

  explicit EqualPair(double s) {
    const MultipoleMobility m = multipole_mobility(Numbers{4, 4}, Numbers{0, 4 * s}, eta);
    self = m.value(0, 0) / self_mobility(4, eta);
    pair = m.value(0, 1) / self_mobility(4, eta);
  }
};

/// Returns the largest difference of an element mu_ij, divided by sqrt(mu_ii mu_jj).
double relative_difference(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b) {
  const Eigen::VectorXd root = b.diagonal().cwiseSqrt();
  return ((a - b).cwiseAbs().array() / (root * root.transpose()).array()).maxCoeff();
}

double largest(const std::vector<Eigen::MatrixXd>& matrices) {
  double size = 0;
  for (const Eigen::MatrixXd& matrix : matrices) size = std::max(size, matrix.cwiseAbs().maxCoeff());
  return size;
}

/// Spheres on a line with random radii (ratio up to 10) and random gaps (0.1 to 3 times the smaller radius of
/// the two neighbours).
struct RandomLine {
  Numbers radii, positions;

  RandomLine(std::mt19937& random, int size) {
    std::uniform_real_distribution<double> log_radius(0, std::log(10.0)), gap(0.1, 3);
    for (int i = 0; i < size; ++i) {
      radii.push_back(std::exp(log_radius(random)));
      const double touching = i == 0 ? 0 : radii[i - 1] + radii[i];
      positions.push_back(
          i == 0 ? -7 : positions[i - 1] + touching + gap(random) * std::min(radii[i - 1], radii[i]));
    }
  }
};

TEST(MultipoleMobility, IsThatOfStokesForALoneSphere) {
  const MultipoleMobility m = multipole_mobility(Numbers{5}, Numbers{3}, eta);
  EXPECT_DOUBLE_EQ(m.value(0, 0), self_mobility(5, eta));
  EXPECT_EQ(m.slope[0](0, 0), 0);
}

TEST(MultipoleMobility, GivesStimsonAndJefferysDragOfSpheresThatMoveAlike) {
  constexpr double truncation = 1e-12;
  for (const double s : {2.02, 2.05, 2.1, 2.5, 3.0, 5.0, 20.0}) {
    const EqualPair x(s);
    EXPECT_NEAR(1 / (x.self + x.pair) / stimson_jeffery(s), 1, truncation) << "s = " << s;
  }
}

// Lubrication: the drag grows as 1/gap, so truncation and roundoff count over the gap.
TEST(MultipoleMobility, GivesBrennersDragOfSpheresThatApproach) {
  constexpr double truncation = 1e-12;
  for (const double s : {2.02, 2.05, 2.1, 2.5, 3.0, 5.0, 20.0}) {
    const EqualPair x(s);
    EXPECT_NEAR(1 / (x.self - x.pair) / approaching_spheres(s), 1, truncation / (s - 2)) << "s = " << s;
  }
}

// Catches radii that are mixed up in the way between spheres, which equal spheres hide.
TEST(MultipoleMobility, IsThatOfBisphericalCoordinatesForUnequalSpheres) {
  constexpr double truncation = 1e-12;  // over the gap, in mean radii
  for (const double small : {3.0, 1.0, 0.25}) {
    for (const double gap : {0.1, 0.5, 4.0}) {
      const double distance = (4 + small) * (1 + gap / 2);
      const Eigen::MatrixXd mobility = multipole_mobility(Numbers{4, small}, Numbers{0, distance}, eta).value;
      const Eigen::Matrix2d exact = bispherical_resistance(4, small, distance, eta).inverse();
      EXPECT_LT(relative_difference(mobility, exact), truncation / gap)
          << "small = " << small << ", gap = " << gap;
    }
  }
}

// Three equal spheres, 5 radii apart. Reference: an independent calculation with axisymmetric multipoles, to
// the six digits that it was stated with.
TEST(MultipoleMobility, GivesReferenceOfThreeSpheres) {
  constexpr double printed_digits = 0.5e-6;
  const Eigen::MatrixXd m =
      multipole_mobility(Numbers{4, 4, 4}, Numbers{-20, 0, 20}, eta).value / self_mobility(4, eta);
  EXPECT_NEAR(m(0, 0), 0.993897, printed_digits);
  EXPECT_NEAR(m(1, 1), 0.988811, printed_digits);
  EXPECT_NEAR(m(0, 1), 0.290621, printed_digits);
  EXPECT_NEAR(m(0, 2), 0.154068, printed_digits);
}

// A sphere in the strain -F/(4 pi eta r_12^2) of a force F on sphere 1 resists with the stresslet
// (20/3) pi eta a_2^3 E, whose flow on the axis is -3 S/(8 pi eta r_23^2): sphere 3 gains
// 5 a_2^3 F / (8 pi eta r_12^2 r_23^2). The rest falls two powers faster.
TEST(MultipoleMobility, TendsToStressletOfTheSphereBetween) {
  const auto rest = [](double unit) {
    const double r_12 = 5 * unit, r_23 = 7 * unit;
    const Eigen::MatrixXd m = multipole_mobility(Numbers{1, 2, 3}, Numbers{0, r_12, r_12 + r_23}, eta).value;
    const double leading = 5 * 8 / (8 * std::numbers::pi * eta * r_12 * r_12 * r_23 * r_23);
    return (m(0, 2) - rotne_prager(1, 3, r_12 + r_23, eta).value) / leading - 1;
  };
  constexpr double next_order = 0.05;  // of the exponent 2: error of the asymptotic rate at these distances
  EXPECT_NEAR(std::log2(rest(8) / rest(16)), 2, next_order);
  EXPECT_NEAR(std::log2(rest(16) / rest(32)), 2, next_order);
  EXPECT_LT(std::abs(rest(32)), 2e-3);
}

// Spheres 2 and 3, in the strains of the force on sphere 1, cause the axial stresslets 5/2 a^3 F/r^2. The
// rest falls two powers faster.
TEST(MultipoleMobility, HasStressletsOfSpheresInTheStrainOfAForce) {
  const auto rest = [](double unit) {
    const double r_12 = 5 * unit, r_13 = 12 * unit;
    const MultipoleMobility m = multipole_mobility(Numbers{1, 2, 3}, Numbers{0, r_12, r_13}, eta);
    return m.stresslet[0] / (2.5 * (8 / (r_12 * r_12) + 27 / (r_13 * r_13))) - 1;
  };
  constexpr double next_order = 0.1;  // of the exponent 2: error of the asymptotic rate at these distances
  EXPECT_NEAR(std::log2(rest(64) / rest(128)), 2, next_order);
  EXPECT_LT(std::abs(rest(32)), 2e-4);
}

TEST(MultipoleMobility, SlopesAreDerivativesByEachPosition) {
  constexpr double truncation = 2e-8;  // central difference of step 1e-4, relative to the largest slope
  constexpr double step = 1e-4;
  const Numbers radii{4, 3, 0.7, 5}, positions{-9, 0, 4.5, 13};
  const MultipoleMobility m = multipole_mobility(radii, positions, eta);
  for (std::size_t k = 0; k < radii.size(); ++k) {
    Numbers ahead = positions, behind = positions;
    ahead[k] += step;
    behind[k] -= step;
    const MultipoleMobility after = multipole_mobility(radii, ahead, eta);
    const MultipoleMobility before = multipole_mobility(radii, behind, eta);
    const Eigen::MatrixXd difference = (after.value - before.value) / (2 * step);
    EXPECT_LT((m.slope[k] - difference).cwiseAbs().maxCoeff() / largest(m.slope), truncation) << k;
    const Eigen::VectorXd change = (after.stresslet - before.stresslet) / (2 * step);
    EXPECT_LT((m.stresslet_slope.col(k) - change).norm() / m.stresslet_slope.norm(), truncation) << k;
  }
}

TEST(MultipoleMobility, IsSymmetricAndDissipatesForRandomSpheres) {
  constexpr unsigned seed = 20170302;
  SCOPED_TRACE(testing::Message() << "seed " << seed);
  std::mt19937 random(seed);
  for (int trial = 0; trial < 20; ++trial) {
    const RandomLine line(random, 2 + trial % 3);
    const Eigen::MatrixXd m = multipole_mobility(line.radii, line.positions, eta, 1e-8).value;
    EXPECT_EQ(m, m.transpose()) << "trial " << trial;
    EXPECT_GT(m.selfadjointView<Eigen::Lower>().eigenvalues().minCoeff(), 0) << "trial " << trial;
  }
}

// The stated tolerance against a much finer one, of values and of slopes over the largest slope.
TEST(MultipoleMobility, MeetsItsTolerance) {
  constexpr unsigned seed = 20170303;
  SCOPED_TRACE(testing::Message() << "seed " << seed);
  std::mt19937 random(seed);
  for (int trial = 0; trial < 12; ++trial) {
    const RandomLine line(random, 2 + trial % 3);
    const MultipoleMobility fine = multipole_mobility(line.radii, line.positions, eta, 1e-14);
    for (const double tolerance : {1e-4, 1e-7, 1e-10}) {
      const MultipoleMobility m = multipole_mobility(line.radii, line.positions, eta, tolerance);
      EXPECT_LT(relative_difference(m.value, fine.value), tolerance) << "trial " << trial;
      for (std::size_t k = 0; k < m.slope.size(); ++k) {
        const double error = (m.slope[k] - fine.slope[k]).cwiseAbs().maxCoeff() / largest(fine.slope);
        EXPECT_LT(error, tolerance) << "trial " << trial << ", position " << k;
      }
    }
  }
}

TEST(MultipoleMobility, ScalesWithUnits) {
  constexpr double roundoff = 1e-14;
  const MultipoleMobility m = multipole_mobility(Numbers{4, 3, 5}, Numbers{-9, 0, 12}, eta);
  const MultipoleMobility scaled =
      multipole_mobility(Numbers{0.4, 0.3, 0.5}, Numbers{-0.9, 0, 1.2}, 30 * eta);
  EXPECT_LT(relative_difference(scaled.value * 3, m.value), roundoff);
  EXPECT_LT((scaled.slope[1] * 0.3 - m.slope[1]).cwiseAbs().maxCoeff() / largest(m.slope), roundoff);
}

TEST(MultipoleMobility, MirrorsWithTheSpheres) {
  constexpr double roundoff = 1e-14;
  const MultipoleMobility m = multipole_mobility(Numbers{4, 3, 5}, Numbers{-9, 0, 12}, eta);
  const MultipoleMobility mirrored = multipole_mobility(Numbers{5, 3, 4}, Numbers{-12, 0, 9}, eta);
  EXPECT_LT(relative_difference(mirrored.value.reverse(), m.value), roundoff);
  EXPECT_LT((mirrored.slope[2].reverse() + m.slope[0]).cwiseAbs().maxCoeff() / largest(m.slope), roundoff);
}

TEST(MultipoleMobility, RefusesWhatItCannotSolve) {
  const Numbers pair{4, 3};
  EXPECT_THROW(multipole_mobility(pair, Numbers{0, 7}, eta), InputError) << "touching";
  EXPECT_THROW(multipole_mobility(pair, Numbers{9, 0}, eta), InputError) << "in the wrong order";
  EXPECT_THROW(multipole_mobility(pair, Numbers{0, 7.0001}, eta), InputError) << "too near for the limit";
  EXPECT_THROW(multipole_mobility(pair, Numbers{0}, eta), InputError) << "a position is missing";
  EXPECT_THROW(multipole_mobility(Numbers{4, -3}, Numbers{0, 9}, eta), InputError) << "negative radius";
  EXPECT_THROW(multipole_mobility(pair, Numbers{0, std::nan("")}, eta), InputError)
      << "position not a number";
  EXPECT_THROW(multipole_mobility(pair, Numbers{0, 9}, 0), InputError) << "no viscosity";
  EXPECT_THROW(multipole_mobility(pair, Numbers{0, 9}, eta, 0), InputError) << "no tolerance";
}

}  // namespace
}  // namespace beadswim
