// Tests of swimmers that start elsewhere than at rest: their beads, their motion with the swimmer, and
// faults.
#include <gtest/gtest.h>

#include "beadswim/scene/bead_gaps.hpp"
#include "beadswim/scene/check.hpp"
#include "beadswim/scene/combine.hpp"
#include "beadswim/scene/presets.hpp"
#include "beadswim/scene/unit_scales.hpp"

namespace beadswim {
namespace {

const std::vector<Vec3> places{{-21, 1, 0}, {0, 0, 0.5}, {19, 0, 0}};

Layout started() {
  Layout layout = paper_single();
  layout.domain = {};
  layout.swimmers = {{.id = 0, .type = "a"}};
  layout.swimmers[0].start = SwimmerStart{.positions = places};
  return layout;
}

std::vector<Vec3> beads_of(const Layout& layout) {
  std::vector<Vec3> beads;
  for (const PlacedBead& bead : placed_beads(layout)) beads.push_back(bead.centre);
  return beads;
}

TEST(Start, BeadsAreWhereTheLayoutSays) {
  EXPECT_TRUE(check_layout(started()).empty());
  EXPECT_EQ(beads_of(started()), places);
}

TEST(Start, MovesAndTurnsWithTheSwimmer) {
  Layout layout = started();
  layout.swimmers[0].move_to(Vec3(1, 2, 4));
  const Eigen::Quaterniond quarter(Eigen::AngleAxisd(EIGEN_PI / 2, Vec3::UnitZ()));
  turn_swimmer(layout.swimmers[0], layout.types.at("a"), quarter);
  for (std::size_t b = 0; b < places.size(); ++b) {
    const Vec3 expected = Vec3(1, 2, 4) + Vec3(-places[b].y(), places[b].x(), places[b].z());
    EXPECT_LT((beads_of(layout)[b] - expected).norm(), 1e-13 * 20);
  }
}

TEST(Start, HasTheUnitOfLength) {
  EXPECT_EQ(beads_of(in_units(started(), {.length = 0.5}))[0], 2 * places[0]);
}

TEST(Start, NeedsAPlaceForEachBeadAndBondsOfPossibleLength) {
  Layout layout = started();
  layout.swimmers[0].start->positions[2].x() = 41;
  ASSERT_EQ(check_layout(layout).size(), 1);
  EXPECT_EQ(check_layout(layout)[0].place, "/swimmers/0/start/positions");
  EXPECT_NE(check_layout(layout)[0].message.find("more than twice the rest length"), std::string::npos);
  layout.swimmers[0].start->positions.pop_back();
  ASSERT_EQ(check_layout(layout).size(), 1);
  EXPECT_NE(check_layout(layout)[0].message.find("has 2 positions"), std::string::npos);
}

TEST(Start, OverlapsAreFound) {
  Layout layout = started();
  layout.swimmers[0].start->positions[0].x() = -7;
  ASSERT_EQ(check_layout(layout).size(), 1);
  EXPECT_NE(check_layout(layout)[0].message.find("overlaps"), std::string::npos);
}

}  // namespace
}  // namespace beadswim
