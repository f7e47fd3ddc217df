#include "beadswim/scene/bead_gaps.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <random>
#include <set>

namespace beadswim {
namespace {

constexpr double roundoff = 1e-12;  // a few hundred units in the last place of distances of order 10

const Box mixed_box{.lengths = Vec3(9, 30, 17),
                    .boundary = {Boundary::periodic, Boundary::no_slip, Boundary::periodic}};

/// Returns the smallest distance of bead i to any image of bead j by a search over all images. If i and j are
/// the same bead, the bead itself is omitted.
double nearest_image_distance(const PlacedBead& i, const PlacedBead& j, const std::optional<Box>& domain) {
  double nearest = std::numeric_limits<double>::infinity();
  for (int shift = 0; shift < 27 * 27; ++shift) {
    const Eigen::Array3i n(shift % 9 - 4, shift / 9 % 9 - 4, shift / 81 - 4);
    Vec3 image = j.centre;
    bool exists = true;
    for (int axis = 0; axis < 3; ++axis) {
      const bool periodic = domain && domain->boundary[axis] == Boundary::periodic;
      exists = exists && (periodic || n[axis] == 0);
      if (periodic) image[axis] += n[axis] * domain->lengths[axis];
    }
    if (!exists || (&i == &j && (n == 0).all())) continue;
    nearest = std::min(nearest, (image - i.centre).norm());
  }
  return nearest;
}

/// Returns beads of different radii at random positions inside the box and up to one box length outside, as
/// beads on unwrapped arms can be.
std::vector<PlacedBead> random_beads(int seed, std::size_t count) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> place(-1, 2);
  std::uniform_real_distribution<double> inside(0, 1);
  std::uniform_real_distribution<double> radius(0.2, 1);
  std::vector<PlacedBead> beads;
  for (std::size_t i = 0; i < count; ++i) {
    const Vec3 x(9 * place(random), 2 + 26 * inside(random), 17 * place(random));
    beads.push_back({x, radius(random), i / 3, static_cast<int>(i % 3)});
  }
  return beads;
}

class BeadGaps : public testing::TestWithParam<int> {};

TEST_P(BeadGaps, FindEveryOverlapThatTryingAllImagesFinds) {
  RecordProperty("seed", GetParam());
  const auto beads = random_beads(GetParam(), 150);
  std::set<std::pair<std::size_t, std::size_t>> expected, found;
  for (std::size_t i = 0; i < beads.size(); ++i) {
    for (std::size_t j = 0; j <= i; ++j) {
      const double contact = beads[i].radius + beads[j].radius;
      if (nearest_image_distance(beads[i], beads[j], mixed_box) <= contact) expected.insert({i, j});
    }
  }
  for (const BeadPair& pair : overlapping_pairs(beads, mixed_box, 10'000)) {
    EXPECT_TRUE(found.insert({pair.first, pair.second}).second) << "a pair was found twice";
  }
  EXPECT_FALSE(expected.empty());
  EXPECT_EQ(found, expected);
}

TEST_P(BeadGaps, SmallestGapIsThatOfAllPairsImagesAndWalls) {
  RecordProperty("seed", GetParam());
  for (const std::optional<Box>& domain : {std::optional<Box>(mixed_box), std::optional<Box>()}) {
    const auto beads = random_beads(GetParam(), 4);
    double expected = std::numeric_limits<double>::infinity();
    for (const PlacedBead& i : beads) {
      for (const PlacedBead& j : beads) {
        expected = std::min(expected, nearest_image_distance(i, j, domain) - i.radius - j.radius);
      }
      if (domain) expected = std::min({expected, i.centre[1] - i.radius, 30 - i.centre[1] - i.radius});
    }
    EXPECT_NEAR(smallest_gap(beads, {.box = domain}), expected, roundoff);
  }
}

INSTANTIATE_TEST_SUITE_P(Seeds, BeadGaps, testing::Range(1, 9));

// A cell list that leaves out one of the 26 neighbours of a cell misses pairs along one direction only.
TEST(BeadGapsOfTwoBeads, AreFoundInEveryDirectionFromEveryPlace) {
  constexpr int seed = 3;
  RecordProperty("seed", seed);
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> place(0, 12);
  const Box box{.lengths = Vec3(12, 12, 12), .boundary = {}};
  for (int direction = 0; direction < 27; ++direction) {
    const Vec3 offset(direction % 3 - 1, direction / 3 % 3 - 1, direction / 9 - 1);
    for (int trial = 0; trial < 500; ++trial) {
      const Vec3 x(place(random), place(random), place(random));
      const std::vector<PlacedBead> beads{{x, 1, 0, 0}, {x + 1.99 * offset.stableNormalized(), 1, 1, 0}};
      ASSERT_EQ(overlapping_pairs(beads, box, 10).size(), 1u) << "direction " << offset.transpose();
      ASSERT_EQ(overlapping_pairs(beads, std::nullopt, 10).size(), 1u) << "direction " << offset.transpose();
    }
  }
}

TEST(BeadGapsOfOneBead, ABoxNarrowerThanTheBeadMakesItOverlapItself) {
  const Box box{.lengths = Vec3(10, 4, 10), .boundary = {}};
  const std::vector<PlacedBead> beads{{Vec3(5, 2, 5), 2, 0, 0}};
  const auto pairs = overlapping_pairs(beads, box, 10);
  ASSERT_EQ(pairs.size(), 1u);
  EXPECT_EQ(pairs[0].first, pairs[0].second);
  EXPECT_EQ(pairs[0].distance, 4);
}

// Coordinates that overflow a cell's index must not hide an overlap.
TEST(BeadGapsOfFarBeads, BeadsFarFromTheOriginAreStillFound) {
  const std::vector<PlacedBead> beads{{Vec3(1e300, 0, 0), 1, 0, 0}, {Vec3(1e300, 1.5, 0), 1, 0, 1}};
  EXPECT_EQ(overlapping_pairs(beads, std::nullopt, 10).size(), 1u);
}

}  // namespace
}  // namespace beadswim
