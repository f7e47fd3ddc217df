// Tests of nearest-neighbour distances: comparison with a search over all pairs of images, and with regular
// lattices.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "beadswim/compare/nearest_neighbours.hpp"
#include "beadswim/core/keyed_random.hpp"
#include "tolerances.hpp"

namespace beadswim {
namespace {

using enum Boundary;

constexpr std::uint64_t seed = 11;
constexpr double infinity = std::numeric_limits<double>::infinity();

const std::vector<Box> boxes{
    {{10, 10, 10}, {periodic, periodic, periodic}},   {{10, 10, 10}, {free_slip, free_slip, free_slip}},
    {{20, 5, 10}, {periodic, free_slip, periodic}},   {{8, 5, 30}, {free_slip, free_slip, periodic}},
    {{20, 0.3, 15}, {periodic, periodic, periodic}},  {{0.2, 50, 0.1}, {periodic, periodic, periodic}},
    {{20, 0.3, 15}, {periodic, free_slip, periodic}},
};

std::vector<Vec3> random_points(const Box& box, std::uint64_t count) {
  std::vector<Vec3> points;
  for (std::uint64_t i = 0; i < count; ++i) {
    KeyedRandom random(seed, i, count);
    const double x = random.uniform(), y = random.uniform(), z = random.uniform();
    points.push_back(box.lengths.cwiseProduct(Vec3(x, y, z)));
  }
  return points;
}

/// Returns nearest-neighbour distances by a search over all images of the points, up to two boxes away.
std::vector<double> brute_force(const std::vector<Vec3>& points, const Box& box) {
  const auto reach = [&](int axis) { return box.is_periodic(axis) ? 2 : 0; };
  std::vector<double> nearest(points.size(), infinity);
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (std::size_t j = 0; j < points.size(); ++j) {
      for (int a = -reach(0); a <= reach(0); ++a) {
        for (int b = -reach(1); b <= reach(1); ++b) {
          for (int c = -reach(2); c <= reach(2); ++c) {
            if (i == j && a == 0 && b == 0 && c == 0) continue;
            const Vec3 image = points[j] + box.lengths.cwiseProduct(Vec3(a, b, c));
            nearest[i] = std::min(nearest[i], (image - points[i]).norm());
          }
        }
      }
    }
  }
  return nearest;
}

std::vector<double> distances_in(const Box& box, const std::vector<Vec3>& points) {
  return nearest_neighbour_distances(points, box);
}

void expect_same(const std::vector<double>& distances, const std::vector<double>& expected,
                 double tolerance) {
  ASSERT_EQ(distances.size(), expected.size());
  for (std::size_t i = 0; i < distances.size(); ++i) {
    if (std::isinf(expected[i])) {
      EXPECT_EQ(distances[i], expected[i]) << i;
    } else {
      EXPECT_NEAR(distances[i], expected[i], tolerance) << i;
    }
  }
}

// Would catch a search that stops too early, and images forgotten along one axis or across corners.
TEST(NearestNeighbours, AreThoseAmongAllPairsOfImages) {
  for (const Box& box : boxes) {
    for (const std::uint64_t count : {1, 2, 3, 7, 60, 200}) {
      SCOPED_TRACE(testing::Message()
                   << "box " << box.lengths.transpose() << ", " << count << " points, seed " << seed);
      const std::vector<Vec3> points = random_points(box, count);
      expect_same(distances_in(box, points), brute_force(points, box), 50 * roundoff(4));
    }
  }
}

// Swimmers are unwrapped: would catch images sought around the box alone.
TEST(NearestNeighbours, DoNotDependOnWholePeriods) {
  for (const Box& box : boxes) {
    SCOPED_TRACE(testing::Message() << "box " << box.lengths.transpose() << ", seed " << seed);
    const std::vector<Vec3> points = random_points(box, 100);
    std::vector<Vec3> shifted = points;
    for (std::size_t i = 0; i < points.size(); ++i) {
      KeyedRandom random(seed, i, 0);
      for (int axis = 0; axis < 3; ++axis) {
        const double periods = std::floor(2001 * random.uniform()) - 1000;
        if (box.is_periodic(axis)) shifted[i][axis] += periods * box.lengths[axis];
      }
    }
    const double largest = 1001 * box.lengths.maxCoeff();
    expect_same(distances_in(box, shifted), distances_in(box, points), largest * roundoff(4));
  }
}

/// Returns the n^3 points of a simple cubic lattice whose first point is the origin.
std::vector<Vec3> cubic_lattice(int n, double spacing) {
  std::vector<Vec3> points;
  for (int i = 0; i < n * n * n; ++i) points.push_back(spacing * Vec3(i % n, i / n % n, i / n / n));
  return points;
}

// All coordinates are shared by many points: would catch a tree that puts equal ones on one side alone.
TEST(NearestNeighbours, OfACubicLatticeAreItsSpacingAway) {
  constexpr int n = 8;
  constexpr double spacing = 32;
  const std::vector<double> expected(n * n * n, spacing);
  for (const Boundary boundary : {periodic, free_slip}) {
    const Box box{Vec3::Constant(n * spacing), {boundary, boundary, boundary}};
    expect_same(distances_in(box, cubic_lattice(n, spacing)), expected, 0);
  }
}

// A run of a unit cell says what one of many cells would: would catch own images counted by lone points only.
TEST(NearestNeighbours, OfAUnitCellAreThoseOfManyCells) {
  const Box cell{{90, 7, 11}, {periodic, periodic, periodic}};
  const Box cells{{180, 21, 22}, {periodic, periodic, periodic}};
  const std::vector<Vec3> in_cell = random_points(cell, 4);
  std::vector<Vec3> in_cells;
  for (int i = 0; i < 12; ++i) {
    for (const Vec3& point : in_cell) {
      in_cells.push_back(point + cell.lengths.cwiseProduct(Vec3(i % 2, i / 2 % 3, i / 6)));
    }
  }
  std::vector<double> expected;
  for (int i = 0; i < 12; ++i) {
    for (const double distance : distances_in(cell, in_cell)) expected.push_back(distance);
  }
  expect_same(distances_in(cells, in_cells), expected, 200 * roundoff(4));
}

TEST(NearestNeighbours, OfALonePointAreItsOwnImages) {
  const std::vector<Vec3> point{{-3, 40, 7}};
  EXPECT_EQ(distances_in(Box{{9, 5, 6}, {periodic, periodic, periodic}}, point).front(), 5);
  EXPECT_EQ(distances_in(Box{{9, 5, 6}, {periodic, free_slip, periodic}}, point).front(), 6);
  EXPECT_EQ(distances_in(Box{{9, 5, 6}, {free_slip, free_slip, free_slip}}, point).front(), infinity);
  EXPECT_TRUE(distances_in(Box{{9, 5, 6}, {periodic, periodic, periodic}}, {}).empty());
}

TEST(NearestNeighbours, InOnePlaceAreNoDistanceAway) {
  const std::vector<Vec3> points(500, Vec3(3, -2, 1));
  expect_same(distances_in(boxes.front(), points), std::vector<double>(500, 0), 0);
}

// A grid of cells over all points would hold the crowd in one cell and take hours.
TEST(NearestNeighbours, OfACrowdWithAStragglerAreFoundAtOnce) {
  constexpr double far = 1e9;
  std::vector<Vec3> points = cubic_lattice(46, 1);
  std::vector<double> expected(points.size(), 1);
  points.push_back(Vec3(-far, 0, 0));
  expected.push_back(far);
  expect_same(distances_in(Box{{1, 1, 1}, {free_slip, free_slip, free_slip}}, points), expected, 0);
}

// NaN has no place in an order: would catch a sort of such points, which is undefined.
TEST(NearestNeighbours, OfPointsThatAreNotFiniteAreNotNumbers) {
  for (const double bad : {infinity, std::numeric_limits<double>::quiet_NaN()}) {
    std::vector<Vec3> points = random_points(boxes.front(), 50);
    points[20][1] = bad;
    for (const double distance : distances_in(boxes.front(), points)) EXPECT_TRUE(std::isnan(distance));
  }
}

}  // namespace
}  // namespace beadswim
