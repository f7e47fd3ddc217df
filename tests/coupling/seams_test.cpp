// Runs on several ranks: swimmers must not notice the seams of ranks and of the periodic box.
#include <gtest/gtest.h>

#include "beadswim/core/error.hpp"
#include "beadswim/coupling/gather.hpp"
#include "scenes.hpp"

namespace beadswim::test {
namespace {

/// Two swimmers: one along a diagonal across the box's corner, one whose bead 2 swings to and fro across the
/// middle of the box, where ranks meet.
CoupledScene crossing_scene() {
  CoupledScene scene = small_swimmer(Index3(26, 22, 20), Vec3(0.3, 21.8, 19.6), Vec3(1, 1, 1).normalized());
  scene.swimmers.push_back({.id = 7, .type = 1, .position = Vec3(13.1, 11, 10), .axis = Vec3::UnitX()});
  scene.types.push_back(scene.types[0]);
  scene.types[1].driving.amplitude = {0.4, 0.2};
  return scene;
}

// Catches a missing exchange, a sum whose order depends on ranks, a bead lost or counted twice at a seam, and
// a swimmer mangled on its way to a new owner.
TEST(Seams, GiveTheBitsOfOneRank) {
  const Communicator world(MPI_COMM_WORLD), self(MPI_COMM_SELF);
  CoupledSystem cut(crossing_scene(), world);
  CoupledSystem whole(crossing_scene(), self);
  int owners_changed = 0;
  std::size_t owned = cut.owned_swimmers().size();
  for (int n = 0; n < 240; ++n) {
    cut.step();
    whole.step();
    if (cut.owned_swimmers().size() != owned) ++owners_changed;
    owned = cut.owned_swimmers().size();
  }
  const std::string hash = state_sha256(cut, world);
  if (world.is_root()) {
    EXPECT_EQ(hash, state_sha256(whole, self));
  }
  MPI_Allreduce(MPI_IN_PLACE, &owners_changed, 1, MPI_INT, MPI_SUM, world.get());
  if (world.size() > 1) {
    EXPECT_GT(owners_changed, 0);
  }  // the scene does what it is for
}

// Catches a link or a changing cell whose momentum or mass is lost, or counted twice, at a seam.
TEST(Seams, ConserveMomentumAndMass) {
  const Communicator world(MPI_COMM_WORLD);
  CoupledSystem system(crossing_scene(), world);
  advance(system, 360);
  const SceneTotals totals = system.totals();
  constexpr double roundoff = 1e-12;  // bead momenta of some 0.5 and densities of 0.01, 360 steps
  constexpr double scene_cells = 26 * 22 * 20;
  EXPECT_LT(totals.momentum.norm(), roundoff);
  EXPECT_LT(std::abs(totals.mass_excess), roundoff / scene_cells);
  double fastest = 0;
  for (const SwimmerState& swimmer : system.gather_swimmers()) {
    for (const BeadMotion& bead : swimmer.motion) fastest = std::max(fastest, bead.velocity.norm());
  }
  if (world.is_root()) {
    EXPECT_GT(fastest, 1e-3);
  }
}

TEST(Guards, ReportTheFirstBeadThatIsTooFastOnAllRanks) {
  const Communicator world(MPI_COMM_WORLD);
  CoupledScene scene = small_swimmer(Index3(40, 16, 16), Vec3(20, 8, 8), Vec3::UnitX());
  scene.types[0].driving.amplitude = {0, 60};
  scene.types[0].springs.fill({.stiffness = 0, .rest_length = 7, .damping = 0});
  CoupledSystem system(scene, world);
  EXPECT_FALSE(system.speed_fault());
  int steps = 0;
  while (!system.speed_fault() && ++steps < 20) system.step();
  ASSERT_TRUE(system.speed_fault());
  EXPECT_EQ(system.speed_fault()->bead.swimmer, 0);
  EXPECT_NE(system.speed_fault()->bead.bead, 0);
  EXPECT_GT(system.speed_fault()->speed, 0.5);
}

}  // namespace
}  // namespace beadswim::test
