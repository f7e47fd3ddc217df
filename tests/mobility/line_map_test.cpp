#include "beadswim/mobility/line_map.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <random>

#include "beadswim/collinear/multipole_mobility.hpp"
#include "beadswim/mobility/line_map_table.hpp"
#include "beadswim/mobility/near_field.hpp"

namespace beadswim {
namespace {

using Numbers = std::vector<double>;

constexpr double eta = 1.0 / 3;  // [mass/(length time)]

double full_weight(double /*distance*/) {
  return 1;
}

template <int N>
LineMatrix<N> random_mobility(std::mt19937& random) {
  std::normal_distribution<double> normal;
  const LineMatrix<N> root = LineMatrix<N>::NullaryExpr([&] { return normal(random); });
  return root * root.transpose() + 0.1 * LineMatrix<N>::Identity();
}

template <int N>
void expect_exact_mobility(std::mt19937& random) {
  constexpr double roundoff = 1e-11;
  const LineMatrix<N> exact = random_mobility<N>(random), approximate = random_mobility<N>(random);
  const auto [map, tow_defect] = line_map<N>(exact, approximate);
  const LineMatrix<N> corrected = approximate.array() - tow_defect,
                      mapped = map.transpose() * corrected * map;
  EXPECT_LT((mapped - exact).norm(), roundoff * exact.norm());
  EXPECT_LT((map.colwise().sum().array() - 1).matrix().norm(), roundoff);
  EXPECT_GT(map.determinant(), 0);
}

// Any two mobilities: the exact one by all forces, with the net force kept; never singular.
TEST(LineMap, MakesMobilityExact) {
  constexpr unsigned seed = 20261123;
  SCOPED_TRACE(testing::Message() << "seed " << seed);
  std::mt19937 random(seed);
  for (int trial = 0; trial < 15; ++trial) {
    SCOPED_TRACE(trial);
    expect_exact_mobility<2>(random);
    expect_exact_mobility<3>(random);
  }
}

TEST(LineMap, HasALogarithmForTwoSpheres) {
  constexpr double roundoff = 1e-14;
  for (const double gap : {0.1, 0.6, 4.0}) {
    const std::array radii{1.0, 2.0}, places{0.0, 3 + gap};
    const LineMatrix<2> exact = multipole_mobility(radii, places, eta).value;
    const LineMatrix<2> map = line_map<2>(exact, strained_line<2>(radii, places, eta, full_weight)).map;
    const LineMatrix<2> log = log_of_pair_map(map);
    LineMatrix<2> sum = LineMatrix<2>::Identity(), term = sum;
    for (int n = 1; n < 30; ++n) sum += term = term * log / n;
    EXPECT_LT((sum - map).norm(), roundoff) << "gap " << gap;
  }
  EXPECT_EQ(log_of_pair_map(LineMatrix<2>::Identity()), LineMatrix<2>::Zero());
}

/// Returns the gaps at the nodes of the table, in mean radii, beginning with the smallest gap.
Numbers gaps_from(double thinnest) {
  Numbers gaps;
  for (double gap = 1.001 * thinnest; gap < 30; gap *= 1.37) gaps.push_back(gap);
  return gaps;
}

template <int N>
void expect_tabulated(const std::array<double, N>& radii, const std::array<double, N - 1>& gaps) {
  constexpr double truncation = 5e-8;
  std::array<double, N> line{};
  for (int k = 0; k < N - 1; ++k) line[k + 1] = line[k] + radii[k] + gaps[k] + radii[k + 1];
  const LineMatrix<N> exact = multipole_mobility(radii, line, 1, 1e-10).value;
  const LineMap<N> expected = line_map<N>(exact, strained_line<N>(radii, line, 1, pair_weight)),
                   found = LineMapTable<N>(radii).at(gaps, pair_weight);
  EXPECT_LT((found.map - expected.map).norm(), truncation) << "radius " << radii[0] << ", gap " << gaps[0];
  EXPECT_NEAR(found.tow_defect, expected.tow_defect, truncation)
      << "radius " << radii[0] << ", gap " << gaps[0];
}

// Against the map itself, of multipoles to more digits.
TEST(LineMapTable, OfPairsIsTheMapToItsTruncation) {
  for (const std::array<double, 2> radii : {std::array{4.0, 4.0}, {1.0, 2.0}, {6.0, 1.0}})
    for (const double gap : gaps_from(min_tabulated_gap(radii[0], radii[1], 0.01)))
      expect_tabulated<2>(radii, {gap});
}

TEST(LineMapTable, OfTripletsIsTheMapToItsTruncation) {
  for (const std::array<double, 3> radii : {std::array{4.0, 4.0, 4.0}, {3.0, 1.0, 6.0}}) {
    for (const double first : {0.06, 0.31, 1.7, 3.1, 9.0}) {
      for (const double second : {0.21, 2.9, 30.0}) {
        const std::array<double, 2> gaps{first * (radii[0] + radii[1]) / 2,
                                         second * (radii[1] + radii[2]) / 2};
        if (gaps[0] < min_tabulated_gap(radii[0], radii[1], 0.02)) continue;
        if (gaps[1] < min_tabulated_gap(radii[1], radii[2], 0.02)) continue;
        expect_tabulated<3>(radii, gaps);
      }
    }
  }
}

// Touching, overlapping, and very far: as at the ends, except that tau ends where beads overlap.
TEST(LineMapTable, HoldsGapsAtItsEnds) {
  LineMapTable<2> table({1, 1});
  const auto change = [&](double gap) {
    return LineMatrix<2>(table.at({gap}, pair_weight).map - LineMatrix<2>::Identity());
  };
  const auto tow_defect = [&](double gap) { return table.at({gap}, pair_weight).tow_defect; };
  const LineMatrix<2> nearest = change(0.02);
  EXPECT_LT((change(0) - nearest).norm(), 1e-14);
  EXPECT_LT((change(-0.7) - nearest).norm(), 1e-14);
  EXPECT_NEAR(tow_defect(0.01), tow_defect(0.02) / 2, 1e-14);
  EXPECT_EQ(tow_defect(-0.1), 0);
  EXPECT_TRUE(change(std::nan("")).allFinite());
  EXPECT_LT(change(1e9).norm(), 1e-6);
}

TEST(LineMapTable, HasFilmsOfOneBisphericalCoordinate) {
  EXPECT_NEAR(min_tabulated_gap(1, 1, 0.01), 0.02, 1e-15);
  const double gap = min_tabulated_gap(1, 10, 0.01), distance = 11 + gap;  // R^2 + a^2 - b^2 = 2 R a cosh xi
  EXPECT_NEAR((distance * distance + 100 - 1) / (2 * distance * 10), 1.01, 1e-12);
}

}  // namespace
}  // namespace beadswim
