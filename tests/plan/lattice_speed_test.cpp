#include "beadswim/plan/lattice_speed.hpp"

#include <gtest/gtest.h>

#include <numbers>
#include <vector>

#include "beadswim/core/error.hpp"

namespace beadswim {
namespace {

constexpr double slow = 4e-8, fast = 1e-8;  // core-seconds per cell and step [s]

/// Returns the costs of a machine on which small blocks are faster, because they fit the cache.
std::vector<PrecisionCost> costs() {
  const PrecisionCost one{.cells = {1e3, 1e4, 1e5, 1e6},
                          .seconds_per_cell = {fast, fast, slow, slow},
                          .seconds_per_area = {1e-7, 2e-7, 3e-7, 4e-7}};
  return {one, one};
}

CoupledScene fluid(int edge) {
  CoupledScene scene;
  scene.cells = {edge, edge, edge};
  return scene;
}

/// Catches extrapolation to blocks that were not measured.
TEST(LatticeSpeed, IsLevelBeyondTheMeasuredBlocks) {
  const LatticeSpeed speed(1, costs());
  EXPECT_DOUBLE_EQ(speed.step(fluid(5)), fast * 125);
  EXPECT_DOUBLE_EQ(speed.step(fluid(200)), slow * 8e6);
}

/// Catches a cost by the cells of the whole lattice in place of those of a rank.
TEST(LatticeSpeed, CountsCellsPerRank) {
  const LatticeSpeed one(1, costs()), hundred(100, costs());
  EXPECT_DOUBLE_EQ(one.step(fluid(100)), slow * 1e6);
  EXPECT_DOUBLE_EQ(hundred.step(fluid(100)), fast * 1e6);
}

TEST(LatticeSpeed, AddsTheSurfaceOfBeadsByTheirScheme) {
  const LatticeSpeed speed(1, costs());
  CoupledScene scene = fluid(5);
  scene.types.resize(1);
  scene.types[0].beads.assign(3, {{.radius = 2, .density = 1}});
  scene.swimmers = {{.id = 0, .type = 0, .position = {2, 2, 2}}};
  for (const BeadScheme scheme : all_values<BeadScheme>) {
    scene.bead_boundary = scheme;
    const double area = 3 * 4 * std::numbers::pi * 2 * 2;
    const double seconds = costs()[0].seconds_per_area[static_cast<std::size_t>(scheme)];
    EXPECT_DOUBLE_EQ(speed.step(scene) - speed.step(fluid(5)), seconds * area);
  }
}

/// Catches a cache that was damaged, or written by another version, being believed.
TEST(LatticeSpeed, RefusesWhatNoMachineHas) {
  auto missing = costs(), negative = costs(), too_slow = costs();
  missing[1].cells.pop_back();
  negative[0].seconds_per_cell[2] = -slow;
  too_slow[0].seconds_per_area[0] = 2;
  for (const auto& unsound : {missing, negative, too_slow, std::vector(1, costs()[0])})
    EXPECT_THROW(LatticeSpeed(1, unsound), InputError);
}

}  // namespace
}  // namespace beadswim
