#include "beadswim/coupling/refinement.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <memory>

#include "scenes.hpp"

namespace beadswim::test {
namespace {

/// Returns the same scene with `finer` levels below the coarsest around the beads.
CoupledScene refined(CoupledScene scene, int finer) {
  scene.levels = levels_around(scene, bead_extent(scene), finer + 1).value();
  return scene;
}

/// A run of a scene whose levels follow the beads.
struct FollowingRun {
  FollowingRun(const CoupledScene& scene, const Communicator& ranks)
      : communicator(ranks), system(std::make_unique<CoupledSystem>(scene, ranks)) {}

  void advance(int steps) {
    for (int n = 0; n < steps; ++n) {
      system->step();
      if (auto moved = with_levels_around_beads(*system, communicator)) {
        system = std::move(moved);
        ++moves;
      }
    }
  }

  const Communicator& communicator;
  std::unique_ptr<CoupledSystem> system;
  int moves = 0;
};

/// Returns a swimmer in the middle of a box of 64 x 48 x 48 cells.
CoupledScene swimmer_in_wide_box(BeadScheme scheme) {
  CoupledScene scene = small_swimmer(Index3(64, 48, 48), Vec3(32.3, 24.1, 23.8), Vec3(3, 1, 1).normalized());
  scene.bead_boundary = scheme;
  return scene;
}

/// Returns a sphere that a constant force pulls through a box of 64 x 32 x 32 cells.
CoupledScene towed_sphere(double force) {
  CoupledScene scene = swimmer_in_wide_box(BeadScheme::mr);
  scene.cells = {64, 32, 32};
  scene.types = {sphere_type(2.2)};
  scene.types[0].driving.forces = {{.bead = 0, .direction = Vec3(0.8, 0.6, 0), .constant = force}};
  scene.swimmers = {{.id = 0, .type = 0, .position = Vec3(32.3, 15.9, 16.2)}};
  return scene;
}

// Catches an interface that disturbs the flow of the beads, or wrong rates of the finest level.
TEST(Refinement, GivesTheMotionOfCellsOfOneSize) {
  const Communicator self(MPI_COMM_SELF);
  for (const BeadScheme scheme : {BeadScheme::mr, BeadScheme::psm, BeadScheme::cli, BeadScheme::staircase}) {
    const CoupledScene scene = swimmer_in_wide_box(scheme);
    FollowingRun uniform(scene, self), levels(refined(scene, 2), self);
    double stroke = 0, difference = 0;
    const Vec3 start = uniform.system->owned_swimmers()[0].middle();
    for (int sample = 0; sample < 24; ++sample) {  // two periods
      uniform.advance(10);
      levels.advance(10);
      const SwimmerMotion &one = uniform.system->owned_swimmers()[0].motion,
                          &other = levels.system->owned_swimmers()[0].motion;
      for (int arm = 0; arm < 2; ++arm) {
        const double length = (one[arm + 1].position - one[arm].position).norm();
        stroke = std::max(stroke, std::abs(length - 7));
        difference =
            std::max(difference, std::abs((other[arm + 1].position - other[arm].position).norm() - length));
      }
    }
    EXPECT_LT(difference, 1e-3 * stroke) << to_text(scheme);
    const Vec3 way = uniform.system->owned_swimmers()[0].middle() - start,
               other = levels.system->owned_swimmers()[0].middle() - start;
    EXPECT_LT((other - way).norm(), 2e-3 * way.norm()) << to_text(scheme);
  }
}

// The force is balanced by a body force on all levels. Catches a drag that depends on the distance to the
// coarser level, and a body force that is lost there.
TEST(Refinement, KeepsTheDragOfASphere) {
  const Communicator self(MPI_COMM_SELF);
  FollowingRun uniform(towed_sphere(1e-3), self), levels(refined(towed_sphere(1e-3), 1), self);
  uniform.advance(1200);
  levels.advance(1200);
  const auto velocity = [](const FollowingRun& run) {
    return run.system->owned_swimmers()[0].motion[0].velocity;
  };
  EXPECT_LT((velocity(levels) - velocity(uniform)).norm(), 2e-3 * velocity(uniform).norm());
  EXPECT_EQ(levels.moves, 0);
}

// A fast sphere crosses the seam of the box. The velocities of two runs differ by 2 % in single steps,
// because they cover cells at slightly different times; therefore positions are compared. Catches a level
// that does not follow, or that changes the flow when it moves.
TEST(Refinement, FollowsABead) {
  const Communicator self(MPI_COMM_SELF);
  FollowingRun uniform(towed_sphere(0.6), self), levels(refined(towed_sphere(0.6), 1), self);
  const auto place = [](const FollowingRun& run) { return run.system->owned_swimmers()[0].middle(); };
  const Vec3 start = place(uniform);
  const SceneTotals first = levels.system->totals();
  for (int n = 0; n < 9; ++n) {
    uniform.advance(100);
    levels.advance(100);
    EXPECT_LT((place(levels) - place(uniform)).norm(), 5e-4 * (place(uniform) - start).norm()) << n;
  }
  EXPECT_FALSE(levels.system->fault().has_value());
  EXPECT_GE(levels.moves, 5);
  EXPECT_GT(place(levels)[0], 64);
  const SceneTotals last = levels.system->totals();
  EXPECT_LT((last.momentum - first.momentum).norm(), 1e-11);
  EXPECT_LT(std::abs(last.mass_excess - first.mass_excess), 1e-15);
}

/// Returns a swimmer and a sphere that is pulled away from it, in a box with walls; two levels span the axis
/// y.
CoupledScene sphere_leaves_swimmer() {
  CoupledScene scene = towed_sphere(0.6);
  scene.cells = {128, 32, 96};
  scene.boundary = {Boundary::free_slip, Boundary::periodic, Boundary::no_slip};
  scene.types[0].driving.forces[0].direction = Vec3(1, 0, 0.1).normalized();
  scene.swimmers[0].position = Vec3(71.3, 6.9, 46.2);
  const CoupledScene swimmer = swimmer_in_wide_box(BeadScheme::mr);
  scene.types.push_back(swimmer.types[0]);
  scene.swimmers.push_back({.id = 1, .type = 1, .position = Vec3(62.3, 20.1, 47.8)});
  return scene;
}

// Catches an interface, or a move of levels, that depends on ranks.
TEST(Refinement, HasTheSameBitsOnAnyNumberOfRanks) {
  const Communicator world(MPI_COMM_WORLD), self(MPI_COMM_SELF);
  std::map<std::size_t, int> moves;  // by number of levels
  const auto state = [&](const CoupledScene& scene, const Communicator& ranks) {
    FollowingRun run(scene, ranks);
    run.advance(160);
    EXPECT_FALSE(run.system->fault().has_value());
    moves[scene.levels.size()] += run.moves;
    return state_sha256(*run.system, ranks);
  };
  for (const Precision precision : {Precision::fp64, Precision::fp32}) {
    for (const BeadScheme scheme : {BeadScheme::mr, BeadScheme::psm}) {
      for (CoupledScene scene : {refined(swimmer_in_wide_box(scheme), 2), refined(towed_sphere(0.6), 1),
                                 refined(sphere_leaves_swimmer(), 2)}) {
        scene.precision = precision;
        scene.bead_boundary = scheme;
        const std::string shared = state(scene, world);
        if (world.is_root()) {
          EXPECT_EQ(shared, state(scene, self));
        }
      }
    }
  }
  EXPECT_GT(moves[2], 0);
  EXPECT_GT(moves[3], 0);
}

// The sphere comes too near to the end of the finest level before the levels are due to be checked, when they
// would move. Catches a fault that is forgotten then.
TEST(Refinement, DoesNotForgetAFault) {
  const Communicator self(MPI_COMM_SELF);
  CoupledScene scene = towed_sphere(0.6);
  scene.swimmers[0].position[0] = 32.7;
  Eigen::AlignedBox3d beads = bead_extent(scene);
  beads.max()[0] = 30;  // so that the finest level ends at 38, at a gap of 3.1
  scene.levels = levels_around(scene, beads, 2).value();
  FollowingRun run(scene, self);
  run.advance(14);
  EXPECT_TRUE(run.system->fault().has_value());
  run.advance(4);
  EXPECT_TRUE(run.system->fault().has_value());
  EXPECT_EQ(run.moves, 0);
}

// Catches a bead that leaves its level without notice.
TEST(Refinement, StopsABeadThatLeavesItsLevel) {
  const Communicator self(MPI_COMM_SELF);
  CoupledSystem system(refined(towed_sphere(0.6), 1), self);
  int steps = 0;
  while (!system.fault() && steps < 400) {
    advance(system, 10);
    steps += 10;
  }
  ASSERT_TRUE(system.fault().has_value());
  EXPECT_EQ(system.fault()->kind, FaultKind::level);
}

// Catches levels that cost more than they save.
TEST(Refinement, IsChosenWhereItPays) {
  EXPECT_TRUE(cheapest_levels(small_swimmer(Index3(32, 20, 20), Vec3(16, 10, 10), Vec3::UnitX())).empty());
  const CoupledScene wide = small_swimmer(Index3(256, 256, 256), Vec3(128, 128, 128), Vec3::UnitX());
  const std::vector<Block> levels = cheapest_levels(wide);
  EXPECT_GE(levels.size(), 4u);
  EXPECT_EQ(cheapest_levels(wide, 2).size(), 2u);
  EXPECT_EQ(max_levels(wide), max_finer_levels + 1);
  EXPECT_LT(updates_per_step(levels), 0.01 * wide.cells.cast<double>().prod());
}

}  // namespace
}  // namespace beadswim::test
