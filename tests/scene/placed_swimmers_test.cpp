#include "beadswim/scene/placed_swimmers.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "beadswim/scene/bead_gaps.hpp"
#include "beadswim/scene/gallery.hpp"
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
  const std::vector<Vec3> positions = start_positions(swarm);
  ASSERT_EQ(positions.size(), 9U);
  EXPECT_EQ(bead_radii(swarm).size(), 9U);
  for (int s = 0; s < 3; ++s) EXPECT_EQ(positions[3 * s + 1], swarm.swimmers[s].position);
}

// Each swimmer begins with the lengths that its own drives prescribe. Catches shapes that all swimmers of a
// type share, and beads of the layout's checks that are elsewhere than those of a run.
TEST(PlacedSwimmers, BeginOnTheShapesOfTheirDrives) {
  const SwimmerType type = swimmer_type(Triangle{}, {.density = 1, .kinematic_viscosity = 1.0 / 3});
  Layout layout{.units = {},
                .fluid = {.density = 1, .kinematic_viscosity = 1.0 / 3},
                .domain = {},
                .types = {{"a", type}},
                .swimmers = {},
                .resolution = {}};
  for (const double offset : {0.0, 0.7, 3.0, -2.0}) {
    Swimmer& swimmer = layout.swimmers.emplace_back(
        Swimmer{.id = 9 - static_cast<int>(layout.swimmers.size()), .type = "a"});
    swimmer.position = 100 * static_cast<double>(layout.swimmers.size()) * Vec3::UnitX();
    if (offset != 0) (swimmer.driving = type.driving)->phase_offset = offset;
  }
  const std::vector<PlacedBead> beads = placed_beads(layout);
  ASSERT_EQ(beads.size(), 12U);
  for (std::size_t s = 0; s < 4; ++s) {
    const double offset = layout.resolved_type(layout.swimmers[s]).driving.phase_offset;
    for (int k = 0; k < 3; ++k) {
      const Vec3 side = beads[3 * s + k].centre - beads[3 * s + (k + 1) % 3].centre;
      EXPECT_NEAR(side.norm(), 20 + 4 * std::sin(offset - k * 2 * std::numbers::pi / 3), 1e-11);
    }
  }
  const Swarm swarm = placed_swimmers(layout);
  const std::vector<Vec3> placed = start_positions(swarm);
  for (std::size_t s = 0; s < 4; ++s) {
    const std::size_t other = beads[3 * s].swimmer;
    const auto same = std::ranges::find(swarm.swimmers, layout.swimmers[other].id, &PlacedSwimmer::id);
    for (std::size_t b = 0; b < 3; ++b)
      EXPECT_EQ(placed[3 * (same - swarm.swimmers.begin()) + b], beads[3 * s + b].centre);
  }
  EXPECT_EQ(swarm.types.size(), 4U);
  EXPECT_EQ(swarm.types[0], type);
}

}  // namespace
}  // namespace beadswim
