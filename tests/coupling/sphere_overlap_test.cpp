#include "beadswim/coupling/sphere_overlap.hpp"

#include <gtest/gtest.h>

#include <array>
#include <random>

#include "beadswim/coupling/saturated_cells.hpp"

namespace beadswim::test {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double roundoff = 1e-13;  // some twenty terms of a few cells' volume

/// Returns the volume of a sphere around the origin that lies within the box from `low` to `high`.
double overlap(double radius, const std::array<double, 3>& low, const std::array<double, 3>& high) {
  double volume = 0;
  for (int corner = 0; corner < 8; ++corner) {
    std::array<double, 3> p{};
    for (int a = 0; a < 3; ++a) p[a] = (corner >> a & 1) != 0 ? high[a] : low[a];
    const auto [a, b, c] = std::array{std::abs(p[0]), std::abs(p[1]), std::abs(p[2])};
    const CornerCuts cuts{
        .beyond_one = octant_beyond(a, radius) + octant_beyond(b, radius) + octant_beyond(c, radius),
        .beyond_two =
            octant_beyond(a, b, radius) + octant_beyond(b, c, radius) + octant_beyond(c, a, radius)};
    const int sign = (corner ^ corner >> 1 ^ corner >> 2 ^ 1) & 1;
    volume += (sign != 0 ? -1 : 1) * corner_volume(p[0], p[1], p[2], radius, cuts);
  }
  return volume;
}

TEST(SphereOverlap, IsTheBallTheOctantAndTheBox) {
  EXPECT_NEAR(overlap(1.3, {-2, -2, -2}, {2, 2, 2}), 4 * pi / 3 * std::pow(1.3, 3), roundoff);
  EXPECT_NEAR(overlap(1.3, {0, 0, 0}, {2, 2, 2}), pi / 6 * std::pow(1.3, 3), roundoff);
  EXPECT_NEAR(overlap(1.3, {-0.5, -0.6, -0.4}, {0.5, 0.4, 0.6}), 1, roundoff);
  EXPECT_EQ(overlap(1.3, {1.3, 0, 0}, {2.3, 1, 1}), 0);  // touches the face at one point
}

TEST(SphereOverlap, IsTheCapBeyondAFace) {
  constexpr double radius = 3, distance = 2.9, height = radius - distance;  // a cap within the face of a cell
  EXPECT_NEAR(overlap(radius, {distance, -1, -1}, {distance + 1, 1, 1}),
              pi * height * height * (3 * radius - height) / 3, roundoff);
}

// Cells with one, two and four corners in the ball, one that it cuts through a face. Catches a wrong sign of
// one of the cuts.
TEST(SphereOverlap, IsTheIntegralOfColumns) {
  constexpr double radius = 2.2;
  for (const auto& [x, y, z] : {std::array{0.9, 1.0, 0.8}, std::array{-1.6, 0.7, -1.9},
                                std::array{1.5, -0.4, -1.3}, std::array{-0.5, -2.4, -0.5}}) {
    constexpr int columns = 2000;
    double sum = 0;  // midpoint rule: the integrand has kinks, error some 1e-6
    for (int j = 0; j < columns; ++j) {
      for (int k = 0; k < columns; ++k) {
        const double b = y + (j + 0.5) / columns, c = z + (k + 0.5) / columns;
        const double half = std::sqrt(std::max(0.0, radius * radius - b * b - c * c));
        sum += std::max(0.0, std::min(half, x + 1) - std::max(-half, x));
      }
    }
    EXPECT_NEAR(overlap(radius, {x, y, z}, {x + 1, y + 1, z + 1}), sum / columns / columns, 1e-5);
  }
}

/// Saturated cells of one bead in a periodic box: cells that the bead, or an image of it, covers partly or
/// completely.
class SaturatedCellsOf : public testing::TestWithParam<double> {};
INSTANTIATE_TEST_SUITE_P(Radii, SaturatedCellsOf, testing::Values(0.4, 1.0, 2.2, 4.0, 6.3));

// Catches a cell missed, taken for full, or taken twice at a seam. Seed 1.
TEST_P(SaturatedCellsOf, ABeadAddUpToItsVolumeAndCentre) {
  const double radius = GetParam();
  std::mt19937 random(1);
  std::uniform_real_distribution<double> coordinate(-30, 30);
  const Decomposition decomposition(Index3(16, 15, 17), 4);
  for (int trial = 0; trial < 20; ++trial) {
    std::vector<BeadOnLattice> beads(1);
    beads[0].radius = radius;
    beads[0].motion.position = Vec3(coordinate(random), coordinate(random), coordinate(random));
    if (trial == 0) beads[0].motion.position = Vec3(8, 0, 8.5);  // planes through the centre
    double volume = 0;
    Vec3 moment = Vec3::Zero();
    for (int rank = 0; rank < 4; ++rank) {
      const BlockInLattice at = {.block = decomposition.block(rank),
                                 .cells = decomposition.cells(),
                                 .boundary = {Boundary::periodic, Boundary::periodic, Boundary::periodic}};
      SaturatedCells cells(at, 1);
      cells.find(beads);
      for (int z = 0; z < at.block.size[2]; ++z) {
        for (int y = 0; y < at.block.size[1]; ++y) {
          for (const SaturatedRun& run : cells.runs(y, z)) {
            for (int x = run.low; x < run.high; ++x) {
              const double fraction = cells.fraction(run, x);
              const Vec3 r = run.from_centre(x);
              EXPECT_TRUE((r.cwiseAbs().array() < radius + 0.5).all());
              EXPECT_NEAR(
                  overlap(radius, {r[0] - 0.5, r[1] - 0.5, r[2] - 0.5}, {r[0] + 0.5, r[1] + 0.5, r[2] + 0.5}),
                  fraction, 1e-12);
              volume += fraction;
              moment += fraction * r;
            }
          }
        }
      }
    }
    EXPECT_NEAR(volume, 4 * pi / 3 * std::pow(radius, 3), 1e-10);
    // Centres of parts are not those of cells: the first moment is off by up to some hundredths of a cell.
    EXPECT_LT(moment.norm() / volume, 0.1 / radius);
  }
}

}  // namespace
}  // namespace beadswim::test
