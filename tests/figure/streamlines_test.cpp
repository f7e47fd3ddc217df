#include "beadswim/figure/streamlines.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace beadswim {
namespace {

const Eigen::AlignedBox2d region(PlanePoint(-2, -1), PlanePoint(2, 1));
constexpr double distance = 0.2, step = distance / 10;

double length_of(const Streamline& line) {
  double length = 0;
  for (std::size_t n = 1; n < line.size(); ++n) length += (line[n] - line[n - 1]).norm();
  return length;
}

/// Returns the largest distance of a place in a region from all lines.
double largest_gap(const std::vector<Streamline>& lines, const Eigen::AlignedBox2d& within) {
  double largest = 0;
  for (int n = 0; n < 2500; ++n) {
    const PlanePoint place = within.min() + within.sizes().cwiseProduct(PlanePoint(n % 50, n / 50)) / 49;
    double nearest = 1e9;
    for (const Streamline& line : lines)
      for (const PlanePoint& point : line) nearest = std::min(nearest, (point - place).norm());
    largest = std::max(largest, nearest);
  }
  return largest;
}

/// Returns the least distance of two different lines.
double least_distance(const std::vector<Streamline>& lines) {
  double least = 1e9;
  for (const Streamline& one : lines)
    for (const Streamline& other : lines)
      if (&one != &other)
        for (const PlanePoint& a : one)
          for (const PlanePoint& b : other) least = std::min(least, (a - b).norm());
  return least;
}

// The streamlines of u = ω × r are circles.
TEST(Streamlines, CirclesOfSolidRotationClose) {
  const auto lines =
      streamlines([](const PlanePoint& r) { return PlanePoint(-r.y(), r.x()); }, region, distance);
  int circles = 0;
  for (const Streamline& line : lines) {
    const double radius = line.front().norm();
    for (const PlanePoint& point : line) EXPECT_NEAR(point.norm(), radius, 1e-4 * distance);
    const double side = line[0].x() * line[1].y() - line[0].y() * line[1].x();
    EXPECT_GT(side, 0) << "a line runs against the flow";
    if (radius > 1 - step) continue;  // leaves the region
    EXPECT_EQ(line.front(), line.back());
    EXPECT_NEAR(length_of(line), 2 * std::numbers::pi * radius, step * step / radius);
    ++circles;
  }
  EXPECT_GE(circles, 4);
  EXPECT_LE(circles, 5);
}

TEST(Streamlines, OfUniformFlowAreStraightAndEven) {
  const PlanePoint along = PlanePoint(3, 1).normalized();
  const auto lines = streamlines([&](const PlanePoint&) { return 1e-9 * along; }, region, distance);
  for (const Streamline& line : lines)
    for (const PlanePoint& point : line) {
      const PlanePoint from = point - line.front();
      EXPECT_NEAR(from.x() * along.y() - from.y() * along.x(), 0, 1e-12);
      EXPECT_GE(from.dot(along), 0);
    }
  EXPECT_GT(least_distance(lines), 0.94 * distance);
  EXPECT_LT(largest_gap(lines, {PlanePoint(-1.8, -0.8), PlanePoint(1.8, 0.8)}), 0.75 * distance);
}

// Stagnation-point flow u = (x, -y): lines are hyperbolas x y = const, and none begins at the stagnation
// point.
TEST(Streamlines, OfStagnationPointFlowAreHyperbolas) {
  const auto lines =
      streamlines([](const PlanePoint& r) { return PlanePoint(r.x(), -r.y()); }, region, distance);
  for (const Streamline& line : lines)
    for (const PlanePoint& point : line)
      EXPECT_NEAR(point.x() * point.y(), line.front().x() * line.front().y(), 1e-4);
  EXPECT_GT(least_distance(lines), 0.5 * distance - step);
  EXPECT_LT(largest_gap(lines, {PlanePoint(-1.8, -0.8), PlanePoint(1.8, 0.8)}), 1.2 * distance);
}

// A spiral never closes, and must not fill the figure with its turns.
TEST(Streamlines, SpiralEndsAfterOneTurn) {
  const auto lines =
      streamlines([](const PlanePoint& r) { return PlanePoint(-r.y() - 0.02 * r.x(), r.x() - 0.02 * r.y()); },
                  region, distance);
  for (const Streamline& line : lines) {
    EXPECT_NE(line.front(), line.back());
    EXPECT_LT(length_of(line), 1.1 * 2 * std::numbers::pi * line.front().norm());
  }
}

TEST(Streamlines, FluidAtRestHasNone) {
  EXPECT_TRUE(streamlines([](const PlanePoint&) { return PlanePoint(0, 0); }, region, distance).empty());
}

}  // namespace
}  // namespace beadswim
