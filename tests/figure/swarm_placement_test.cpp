#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "beadswim/figure/swarm_picture.hpp"

namespace beadswim {
namespace {

using testing::ElementsAre;

/// Returns a swimmer along x with arms of length 10.
PicturedSwimmer swimmer_at(const Vec3& centre, const std::array<int, 3>& layer = {}) {
  const Vec3 arm(10, 0, 0);
  return {.beads = {centre - arm, centre, centre + arm}, .radii = {1, 2, 3}, .layer = layer};
}

TEST(SwarmPlacement, SwimmersAreMovedAsAWholeByTheirMiddleBeads) {
  std::vector<PicturedSwimmer> swimmers{swimmer_at({105, -3, 7})};
  wrap_swimmers(swimmers, {.lengths = {100, 50, 20},
                           .boundary = {Boundary::periodic, Boundary::periodic, Boundary::no_slip}});
  EXPECT_EQ(swimmers[0].beads[1], Vec3(5, 47, 7));
  EXPECT_EQ(swimmers[0].beads[0], Vec3(-5, 47, 7));
}

TEST(SwarmPlacement, ABoxAroundSwimmersLeavesADiameterOfRoom) {
  std::vector<PicturedSwimmer> swimmers{swimmer_at({0, 0, 0})};
  EXPECT_EQ(enclose_swimmers(swimmers), Vec3(12 + 16, 12, 12));
  EXPECT_EQ(swimmers[0].beads[0], Vec3(2, 6, 6));
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

}  // namespace
}  // namespace beadswim
