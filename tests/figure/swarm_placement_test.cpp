#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "beadswim/figure/swarm_picture.hpp"

namespace beadswim {
namespace {

using testing::ElementsAre;

/// Returns a swimmer along x with arms of length 10.
PicturedSwimmer swimmer_at(const Vec3& centre, const std::array<int, 3>& layer = {}) {
  const Vec3 arm(10, 0, 0);
  return {.beads = {{centre - arm, 1}, {centre, 2}, {centre + arm, 3}},
          .bonds = {{0, 1}, {1, 2}},
          .layer = layer};
}

TEST(SwarmPlacement, SwimmersAreMovedAsAWholeByTheirMiddleBeads) {
  std::vector<PicturedSwimmer> swimmers{swimmer_at({105, -3, 7})};
  wrap_swimmers(swimmers, {.lengths = {100, 50, 20},
                           .boundary = {Boundary::periodic, Boundary::periodic, Boundary::no_slip}});
  EXPECT_EQ(swimmers[0].beads[1].centre, Vec3(5, 47, 7));
  EXPECT_EQ(swimmers[0].beads[0].centre, Vec3(-5, 47, 7));
}

TEST(SwarmPlacement, ASphereIsItsOwnMiddle) {
  std::vector<PicturedSwimmer> swimmers{{.beads = {{{105, -3, 7}, 2}}}};
  wrap_swimmers(swimmers, {.lengths = {100, 50, 20},
                           .boundary = {Boundary::periodic, Boundary::periodic, Boundary::no_slip}});
  EXPECT_EQ(swimmers[0].beads[0].centre, Vec3(5, 47, 7));
  EXPECT_EQ(enclose_swimmers(swimmers), Vec3(8, 8, 8));
}

TEST(SwarmPlacement, ABoxAroundSwimmersLeavesADiameterOfRoom) {
  std::vector<PicturedSwimmer> swimmers{swimmer_at({0, 0, 0})};
  EXPECT_EQ(enclose_swimmers(swimmers), Vec3(12 + 16, 12, 12));
  EXPECT_EQ(swimmers[0].beads[0].centre, Vec3(2, 6, 6));
}

// C is within a block, D between blocks; along x from the end bead to the facing one.
TEST(SwarmDistances, AreCWithinBlocksAndDBetweenThem) {
  const std::vector<PicturedSwimmer> swimmers{
      swimmer_at({0, 0, 0}, {0, 0, 0}), swimmer_at({0, 30, 0}, {0, 1, 0}), swimmer_at({0, 70, 0}, {0, 2, 0}),
      swimmer_at({50, 0, 0}, {1, 0, 0})};
  std::vector<std::string> labels;
  for (const PictureDistance& distance : swarm_distances(swimmers, {1, 2, 2}))
    labels.push_back(distance.label);
  EXPECT_THAT(labels, ElementsAre("D_x = 30", "C_y = 30", "D_y = 40"));
  EXPECT_TRUE(swarm_distances({swimmers[0]}, {1, 1, 1}).empty());
}

TEST(SwarmDistances, AreBetweenTheEndBeadsThatFaceEachOther) {
  const PicturedSwimmer sphere{.beads = {{{50, 0, 0}, 2}}, .layer = {1, 0, 0}};
  const PicturedSwimmer four{.beads = {{{0, 0, 0}, 1}, {{12, 0, 0}, 1}, {{6, 9, 0}, 1}, {{15, 9, 0}, 1}}};
  const auto found = swarm_distances({four, sphere}, {1, 1, 1});
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].label, "D_x = 35");
}

}  // namespace
}  // namespace beadswim
