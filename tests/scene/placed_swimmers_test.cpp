#include "beadswim/scene/placed_swimmers.hpp"

#include <gtest/gtest.h>

#include "beadswim/scene/presets.hpp"

namespace beadswim {
namespace {

/// Returns three swimmers of one type, not in the order of their ids. Swimmer 2 has individual driving.
Layout three_swimmers() {
  Layout layout = paper_single();
  Swimmer swimmer = layout.swimmers.front();
  layout.swimmers.clear();
  for (const int id : {7, 2, 4}) {
    swimmer.id = id;
    swimmer.position = Vec3(100 * id, 50, 60);
    swimmer.driving.reset();
    if (id == 2) swimmer.driving = Driving{.period = 1000};
    layout.swimmers.push_back(swimmer);
  }
  return layout;
}

// Catches a swimmer that is driven as another of its type, and swimmers out of order.
TEST(PlacedSwimmers, ShareATypeUnlessTheyHaveDrivingOfTheirOwn) {
  const Layout layout = three_swimmers();
  const Swarm swarm = placed_swimmers(layout);
  ASSERT_EQ(swarm.swimmers.size(), 3U);
  EXPECT_EQ(swarm.types.size(), 2U);
  EXPECT_EQ(swarm.swimmers[0].id, 2);
  EXPECT_EQ(swarm.swimmers[1].id, 4);
  EXPECT_EQ(swarm.swimmers[2].id, 7);
  EXPECT_EQ(swarm.type_of(swarm.swimmers[0]).driving.period, 1000);
  EXPECT_EQ(swarm.swimmers[1].type, swarm.swimmers[2].type);
  EXPECT_EQ(swarm.type_of(swarm.swimmers[1]).driving.period, layout.types.begin()->second.driving.period);
}

// Catches beads that are listed by type or in another order than their swimmers.
TEST(PlacedSwimmers, HaveTheirBeadsInTheirOrder) {
  const Swarm swarm = placed_swimmers(three_swimmers());
  const std::vector<Vec3> positions = rest_positions(swarm);
  ASSERT_EQ(positions.size(), 9U);
  EXPECT_EQ(bead_radii(swarm).size(), 9U);
  for (int s = 0; s < 3; ++s) EXPECT_EQ(positions[3 * s + 1], swarm.swimmers[s].position);
}

}  // namespace
}  // namespace beadswim
