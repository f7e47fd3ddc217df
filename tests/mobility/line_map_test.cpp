#include "beadswim/mobility/line_map.hpp"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <random>

#include "beadswim/collinear/multipole_mobility.hpp"
#include "beadswim/mobility/line_map_table.hpp"

namespace beadswim {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;
using Numbers = std::vector<double>;

constexpr double eta = 1.0 / 3;  // [mass/(length time)]

MatrixXd random_mobility(std::mt19937& random, int n) {
  std::normal_distribution<double> normal;
  const MatrixXd root = MatrixXd::NullaryExpr(n, n, [&] { return normal(random); });
  return root * root.transpose() + 0.1 * MatrixXd::Identity(n, n);
}

// Any two mobilities: without a net force the exact one, with the net force kept; never singular.
TEST(LineMap, MakesMobilityExactWithoutNetForce) {
  constexpr unsigned seed = 20261123;
  SCOPED_TRACE(testing::Message() << "seed " << seed);
  std::mt19937 random(seed);
  constexpr double roundoff = 1e-11;
  for (int trial = 0; trial < 30; ++trial) {
    const int n = 2 + trial % 3;
    const MatrixXd exact = random_mobility(random, n), approximate = random_mobility(random, n);
    const MatrixXd map = line_map(exact, approximate), mapped = map.transpose() * approximate * map;
    const MatrixXd zero_sum = MatrixXd::Identity(n, n).array() - 1.0 / n;  // projects
    EXPECT_LT(((mapped - exact) * zero_sum).norm(), roundoff * exact.norm()) << "trial " << trial;
    EXPECT_LT((map.colwise().sum().array() - 1).matrix().norm(), roundoff) << "trial " << trial;
    EXPECT_GT(map.determinant(), 0) << "trial " << trial;
    const VectorXd ones = VectorXd::Ones(n);
    EXPECT_NEAR(ones.dot(mapped.inverse() * ones) / ones.dot(approximate.inverse() * ones), 1, roundoff)
        << "a body of all of them has the approximate drag; trial " << trial;
  }
}

TEST(LineMap, HasALogarithmForTwoSpheres) {
  constexpr double roundoff = 1e-14;
  for (const double gap : {0.1, 0.6, 4.0}) {
    const Numbers radii{1, 2}, places{0, 3 + gap};
    const Eigen::Matrix2d map =
        line_map(multipole_mobility(radii, places, eta).value, rotne_prager_line(radii, places, eta));
    const Eigen::Matrix2d log = log_of_pair_map(map);
    Eigen::Matrix2d sum = Eigen::Matrix2d::Identity(), term = sum;
    for (int n = 1; n < 30; ++n) sum += term = term * log / n;
    EXPECT_LT((sum - map).norm(), roundoff) << "gap " << gap;
  }
  EXPECT_EQ(log_of_pair_map(Eigen::Matrix2d::Identity()), Eigen::Matrix2d::Zero());
}

/// Returns the gaps at the nodes of the table, in mean radii, beginning with the smallest gap.
Numbers gaps_from(double thinnest) {
  Numbers gaps;
  for (double gap = 1.001 * thinnest; gap < 30; gap *= 1.37) gaps.push_back(gap);
  return gaps;
}

// Against the map itself, of multipoles to more digits.
TEST(LineMapTable, OfPairsIsTheMapToItsTruncation) {
  constexpr double truncation = 5e-8;
  for (const std::array<double, 2> radii : {std::array{4.0, 4.0}, {1.0, 2.0}, {6.0, 1.0}}) {
    const PairMapTable table(radii);
    for (const double gap : gaps_from(min_tabulated_gap(radii[0], radii[1], 0.01))) {
      const Numbers places{0, radii[0] + radii[1] + gap};
      const Eigen::Matrix2d log = log_of_pair_map(line_map(
          multipole_mobility(radii, places, eta, 1e-10).value, rotne_prager_line(radii, places, eta)));
      EXPECT_LT((table.log_map(gap) - log.row(0)).norm(), truncation)
          << "radius " << radii[1] << ", gap " << gap;
    }
  }
}

TEST(LineMapTable, OfTripletsIsTheMapToItsTruncation) {
  constexpr double truncation = 5e-8;
  for (const std::array<double, 3> radii : {std::array{4.0, 4.0, 4.0}, {3.0, 1.0, 6.0}}) {
    const TripletMapTable table(radii);
    for (const double first : {0.06, 0.31, 1.7, 9.0}) {
      for (const double second : {0.21, 2.9, 30.0}) {
        const std::array<double, 2> gaps{first * (radii[0] + radii[1]) / 2,
                                         second * (radii[1] + radii[2]) / 2};
        if (gaps[0] < min_tabulated_gap(radii[0], radii[1], 0.02)) continue;
        if (gaps[1] < min_tabulated_gap(radii[1], radii[2], 0.02)) continue;
        const double middle = radii[0] + radii[1] + gaps[0];
        const Numbers places{0, middle, middle + radii[1] + radii[2] + gaps[1]};
        const Eigen::Matrix3d change = line_map(multipole_mobility(radii, places, eta, 1e-10).value,
                                                rotne_prager_line(radii, places, eta)) -
                                       Eigen::Matrix3d::Identity();
        EXPECT_LT((table.change(gaps) - change).norm(), truncation)
            << "radius " << radii[0] << ", gaps " << first << ", " << second;
      }
    }
  }
}

// Touching, overlapping, and very far: as at the ends.
TEST(LineMapTable, HoldsGapsAtItsEnds) {
  const PairMapTable table({1, 1});
  const Eigen::RowVector2d nearest = table.log_map(0.02);
  EXPECT_LT((table.log_map(0) - nearest).norm(), 1e-14);
  EXPECT_LT((table.log_map(-0.7) - nearest).norm(), 1e-14);
  EXPECT_TRUE(table.log_map(std::nan("")).allFinite());
  EXPECT_LT(table.log_map(1e9).norm(), 1e-6);
  EXPECT_EQ(table.log_map(1e9), table.log_map(1e10));
}

TEST(LineMapTable, HasFilmsOfOneBisphericalCoordinate) {
  EXPECT_NEAR(min_tabulated_gap(1, 1, 0.01), 0.02, 1e-15);
  const double gap = min_tabulated_gap(1, 10, 0.01), distance = 11 + gap;  // R^2 + a^2 - b^2 = 2 R a cosh xi
  EXPECT_NEAR((distance * distance + 100 - 1) / (2 * distance * 10), 1.01, 1e-12);
}

}  // namespace
}  // namespace beadswim
