// Tests on several ranks: results must not depend on the boundaries between ranks or on the periodic
// boundary.
#include <gtest/gtest.h>

#include <utility>

#include "beadswim/core/error.hpp"
#include "scenes.hpp"

namespace beadswim::test {
namespace {

/// Returns two swimmers. One lies on a diagonal across the corner of the box. Bead 2 of the other oscillates
/// across the middle of the box, where ranks meet.
CoupledScene crossing_scene() {
  CoupledScene scene = small_swimmer(Index3(26, 22, 20), Vec3(0.3, 21.8, 19.6), Vec3(1, 1, 1).normalized());
  scene.swimmers.push_back({.id = 7, .type = 1, .position = Vec3(13.1, 11, 10)});
  scene.types.push_back(scene.types[0]);
  set_amplitude(scene.types[1].driving, {0.4, 0.2});
  return scene;
}

/// Returns a swimmer with arms of 20 cells in a box that is 15 cells wide, so that its beads come close to
/// its own images and the rank that owns it needs cells around the whole box.
CoupledScene long_arms() {
  CoupledScene scene = small_swimmer(Index3(9, 15, 10), Vec3(4.2, 7, 5.1), Vec3::UnitY());
  set_springs(scene.types[0], {.stiffness = 0.05, .rest_length = 20, .damping = 0});
  scene.types[0].angles[0].stiffness = 200;
  set_amplitude(scene.types[0].driving, {0.02, 0.02});
  return scene;
}

/// Returns two swimmers side by side along z, where ranks meet. The gap of their beads is one to two cells,
/// so that links of both beads end in the same fluid cells.
CoupledScene side_by_side() {
  CoupledScene scene = small_swimmer(Index3(14, 14, 30), Vec3(7.1, 7.3, 15.2), Vec3::UnitZ());
  scene.swimmers.push_back(
      {.id = 3, .type = 0, .position = Vec3(12.8, 7.3, 15.2), .orientation = shortest_turn(Vec3::UnitZ())});
  return scene;
}

/// Returns a scene in a box that is so long along x that the boundary between ranks cuts beads. On one rank,
/// links wrap around the periodic rows of cells instead.
CoupledScene cut_across_x() {
  CoupledScene scene = small_swimmer(Index3(44, 8, 8), Vec3(21.9, 4.1, 3.7), Vec3::UnitX());
  scene.swimmers.push_back({.id = 4, .type = 0, .position = Vec3(43.9, 3.6, 4.4)});
  return scene;
}

/// Returns a swimmer along x between two free-slip walls across x, with a bead within one cell of a wall.
CoupledScene between_mirrors_along_x() {
  CoupledScene scene = small_swimmer(Index3(36, 8, 8), Vec3(10.1, 4.1, 3.7), Vec3::UnitX());
  scene.boundary[0] = Boundary::free_slip;
  return scene;
}

/// Returns swimmers between free-slip and no-slip walls, with beads within one cell of each wall.
CoupledScene between_walls() {
  CoupledScene scene = small_swimmer(Index3(26, 14, 12), Vec3(13, 3.2, 8.7), Vec3::UnitX());
  scene.boundary = {Boundary::periodic, Boundary::free_slip, Boundary::no_slip};
  change(scene.types[0].driving, [](ThreeBeadDriving& driving) { driving.frame = DrivingFrame::body; });
  return scene;
}

/// Returns two swimmers head to head across the boundary between ranks. The driving is so strong that beads
/// collide with beads of the other swimmer and of their own.
CoupledScene colliding() {
  CoupledScene scene = small_swimmer(Index3(40, 12, 12), Vec3(10.2, 6.3, 5.9), Vec3::UnitX());
  scene.swimmers.push_back({.id = 2, .type = 0, .position = Vec3(29.9, 6.9, 6.4)});
  set_springs(scene.types[0], {.stiffness = 0.2, .rest_length = 7, .damping = 0});
  scene.types[0].driving = drives({.amplitude = {1.6, 1.6}, .phase = 1.2, .period = 160});
  scene.friction = 0.5;
  return scene;
}

/// Returns swimmers whose driving forces do not sum to zero, in a periodic box: one type is pulled along a
/// constant direction, the other along its own present axis.
CoupledScene towed() {
  CoupledScene scene = crossing_scene();
  scene.types[0].driving.forces.push_back({.bead = 1, .direction = Vec3(0.6, 0, 0.8), .constant = 0.05});
  scene.types[1].driving.frame = DrivingFrame::body;
  scene.types[1].driving.forces.push_back(
      {.bead = 2, .direction = Vec3::UnitY(), .harmonics = {{.amplitude = 0.1}}});
  return scene;
}

/// Returns the hash of the scene's state after 240 time steps, on rank 0 of the communicator.
std::string final_state(const CoupledScene& scene, const Communicator& communicator) {
  CoupledSystem system(scene, communicator);
  advance(system, 240);
  return state_sha256(system, communicator);
}

// Catches a missing exchange, a sum whose order depends on ranks, a bead lost or counted twice at a seam.
// Each scene has all schemes, and each scheme has both precisions.
TEST(Seams, GiveTheBitsOfOneRank) {
  const Communicator world(MPI_COMM_WORLD), self(MPI_COMM_SELF);
  bool is_single = false;
  for (CoupledScene scene : {crossing_scene(), long_arms(), side_by_side(), cut_across_x(),
                             between_mirrors_along_x(), between_walls(), colliding(), towed()}) {
    is_single = !is_single;
    for (const BeadScheme scheme : all_values<BeadScheme>) {
      scene.precision = std::exchange(is_single, !is_single) ? Precision::fp32 : Precision::fp64;
      scene.bead_boundary = scheme;
      const std::string cut = final_state(scene, world);
      if (world.is_root()) {
        EXPECT_EQ(cut, final_state(scene, self));
      }
    }
  }
}

TEST(Seams, AreAcrossXToo) {
  const Communicator world(MPI_COMM_WORLD);
  const CoupledSystem system(cut_across_x(), world);
  EXPECT_EQ(system.levels().finest().decomposition.grid()[0] > 1, world.size() > 1);
}

// What makes the test above worth its name: swimmers do change owners.
TEST(Seams, HandSwimmersToNewOwners) {
  const Communicator world(MPI_COMM_WORLD);
  CoupledSystem system(crossing_scene(), world);
  int changes = 0;
  for (int n = 0; n < 240; ++n) {
    const std::size_t owned = system.owned_swimmers().size();
    system.step();
    if (system.owned_swimmers().size() != owned) ++changes;
  }
  MPI_Allreduce(MPI_IN_PLACE, &changes, 1, MPI_INT, MPI_SUM, world.get());
  if (world.size() > 1) {
    EXPECT_GT(changes, 0);
  }
}

// Catches a link or a changing cell whose momentum or mass is lost, or counted twice, at a seam.
class Conserving : public testing::TestWithParam<std::tuple<std::tuple<Precision, double>, BeadScheme>> {
 protected:
  CoupledScene as_param(CoupledScene scene) const {
    scene.precision = std::get<0>(std::get<0>(GetParam()));
    scene.bead_boundary = std::get<1>(GetParam());
    return scene;
  }
  /// Runs the system and checks that mass and momentum are conserved. Collective.
  void expect_nothing_lost(CoupledSystem& system) const {
    const double roundoff = std::get<1>(std::get<0>(GetParam()));
    const SceneTotals totals = system.totals();
    EXPECT_LT(totals.momentum.norm(), roundoff);
    EXPECT_LT(std::abs(totals.mass_excess), roundoff / system.levels().finest().decomposition.cells().prod());
  }
};

TEST_P(Conserving, MomentumAndMassAcrossSeams) {
  const Communicator world(MPI_COMM_WORLD);
  CoupledSystem system(as_param(crossing_scene()), world);
  advance(system, 360);
  expect_nothing_lost(system);
  double fastest = 0;
  for (const SwimmerState& swimmer : system.gather_swimmers()) {
    for (const BeadMotion& bead : swimmer.motion) fastest = std::max(fastest, bead.velocity.norm());
  }
  if (world.is_root()) {
    EXPECT_GT(fastest, 1e-3);
  }
}

// Catches a net force that the fluid does not balance, or beads that lack their part of the body force.
TEST_P(Conserving, MomentumUnderANetForce) {
  const Communicator world(MPI_COMM_WORLD);
  CoupledSystem system(as_param(towed()), world);
  advance(system, 360);
  expect_nothing_lost(system);
  EXPECT_GT(system.progress().body_force.norm(), 1e-6);
}

// Roundoff: bead momenta of some 0.5 and densities of 0.01, 360 steps; in single precision of each cell's
// populations, with either sign.
INSTANTIATE_TEST_SUITE_P(Seams, Conserving,
                         testing::Combine(testing::Values(std::tuple{Precision::fp64, 1e-12},
                                                          std::tuple{Precision::fp32, 2e-5}),
                                          testing::Values(BeadScheme::staircase, BeadScheme::cli,
                                                          BeadScheme::mr, BeadScheme::psm)));

// Beads that are driven into each other come close, and into contact, but not deep, and nothing is lost.
TEST_P(Conserving, BeadsThatCollide) {
  const Communicator world(MPI_COMM_WORLD);
  CoupledSystem system(as_param(colliding()), world);
  advance(system, 320);
  ASSERT_FALSE(system.fault()) << "kind " << static_cast<int>(system.fault()->kind);
  expect_nothing_lost(system);
  EXPECT_LT(system.smallest_gap(), 0.02);
  EXPECT_GT(system.smallest_gap(), -0.1);
  EXPECT_GT(system.largest_bead_speed(), 0.05);
}

/// Advances a scene until all ranks know a fault, and some steps further, as a rank does that has not checked
/// yet. Returns the fault.
std::optional<Fault> fault_of(const CoupledScene& scene, const Communicator& communicator) {
  CoupledSystem system(scene, communicator);
  int steps = 0;
  while (!system.fault() && ++steps < 2000) system.step();
  const std::optional<Fault> fault = system.fault();
  for (int n = 0; n < 40; ++n) system.step();
  system.totals();
  return fault;
}

// A fluid that is unstable (tau below 1/2) grows without bound; no rank waits for another, whatever its
// numbers are by then, and the reason is that of one rank.
TEST(Guards, StopAllRanksWhenTheFluidIsUnstable) {
  const Communicator world(MPI_COMM_WORLD), self(MPI_COMM_SELF);
  CoupledScene scene = crossing_scene();
  scene.relaxation_time = 0.45;
  for (const BeadScheme scheme : all_values<BeadScheme>) {
    scene.bead_boundary = scheme;
    const auto on_all = fault_of(scene, world), alone = fault_of(scene, self);
    ASSERT_TRUE(on_all && alone);
    EXPECT_EQ(on_all->step, alone->step);
    EXPECT_EQ(on_all->kind, alone->kind);
  }
}

// Far from beads, and with none that moves, only the totals see it; their step is the one just done.
TEST(Guards, SeeAnUnstableFluidFarFromBeads) {
  const Communicator world(MPI_COMM_WORLD);
  CoupledScene scene = small_swimmer(Index3(40, 14, 30), Vec3(20, 7, 15), Vec3::UnitX());
  set_amplitude(scene.types[0].driving, {1e-3, 1e-3});
  for (Bead& bead : scene.types[0].beads) bead.density = 1e9;  // as good as held in place
  scene.relaxation_time = 0.45;
  CoupledSystem system(scene, world);
  int steps = 0;
  while (!system.fault() && ++steps < 5000) {
    system.step();
    if (steps % 10 == 0) system.totals();
  }
  ASSERT_TRUE(system.fault());
  EXPECT_EQ(system.fault()->kind, FaultKind::not_finite);
  EXPECT_LE(system.fault()->step, system.steps_done());
}

// Two things that go wrong in one step, each on another rank: the same one is told on any number of ranks.
TEST(Guards, TellTheSameOfTwoFaultsOnAnyRanks) {
  const Communicator world(MPI_COMM_WORLD), self(MPI_COMM_SELF);
  CoupledScene scene = colliding();
  scene.types.push_back(scene.types[0]);
  scene.swimmers[1].type = 1;
  for (Bead& bead : scene.types[0].beads) bead.density = 1000;
  change(scene.types[0], [](ThreeBeadSwimmer& type) {
    for (Spring& spring : type.springs) spring.rest_length = 3.5;  // in each other
  });
  scene.types[1].driving = drives({.amplitude = {0, 1e4}, .phase = 1.5, .period = 160});
  const auto on_all = fault_of(scene, world), alone = fault_of(scene, self);
  ASSERT_TRUE(on_all && alone);
  EXPECT_EQ(alone->kind, FaultKind::speed);
  EXPECT_EQ(on_all->kind, alone->kind);
  EXPECT_EQ(on_all->bead, alone->bead);
  EXPECT_EQ(on_all->step, alone->step);
}

TEST(Guards, ReportTheFirstBeadThatIsTooFastOnAllRanks) {
  const Communicator world(MPI_COMM_WORLD);
  CoupledScene scene = small_swimmer(Index3(40, 16, 16), Vec3(20, 8, 8), Vec3::UnitX());
  set_amplitude(scene.types[0].driving, {0, 60});
  set_springs(scene.types[0], {.stiffness = 0, .rest_length = 7, .damping = 0});
  CoupledSystem system(scene, world);
  EXPECT_FALSE(system.fault());
  int steps = 0;
  while (!system.fault() && ++steps < 20) system.step();
  ASSERT_TRUE(system.fault());
  EXPECT_EQ(system.fault()->kind, FaultKind::speed);
  EXPECT_EQ(system.fault()->bead.swimmer, 0);
  EXPECT_NE(system.fault()->bead.bead, 0);
  EXPECT_GT(system.fault()->value, 0.5);
}

}  // namespace
}  // namespace beadswim::test
