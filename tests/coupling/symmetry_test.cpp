#include <gtest/gtest.h>

#include "beadswim/core/error.hpp"
#include "scenes.hpp"

namespace beadswim::test {
namespace {

constexpr int box_edge = 24;
constexpr int one_cycle = 120;

/// Displacement of the mean bead position in one cycle, of a swimmer in the middle of a cube.
Vec3 displacement(const Vec3& axis, double phase) {
  const Communicator self(MPI_COMM_SELF);
  CoupledScene scene = small_swimmer(Index3::Constant(box_edge), Vec3::Constant(box_edge / 2.0), axis);
  scene.types[0].driving.phase = phase;
  CoupledSystem system(scene, self);
  const auto mean = [&system] {
    const SwimmerMotion& motion = system.owned_swimmers()[0].motion;
    return Vec3((motion[0].position + motion[1].position + motion[2].position) / 3);
  };
  const Vec3 start = mean();
  advance(system, one_cycle);
  return mean() - start;
}

constexpr double roundoff = 1e-11;  // sums of a cell's populations in another order, 120 steps

// Catches a link direction, a torque or a coverage test that is not the same along all axes.
TEST(Swimmer, SwimsAlikeAlongEveryLatticeAxis) {
  const double along_x = displacement(Vec3::UnitX(), 1.3)[0];
  EXPECT_GT(std::abs(along_x), 1e-3);
  EXPECT_LT((displacement(Vec3::UnitY(), 1.3) - Vec3(0, along_x, 0)).norm(), roundoff);
  EXPECT_LT((displacement(Vec3::UnitZ(), 1.3) - Vec3(0, 0, along_x)).norm(), roundoff);
  EXPECT_LT((displacement(-Vec3::UnitX(), 1.3) - Vec3(-along_x, 0, 0)).norm(), roundoff);
}

// A swimmer along (1,1,0) may not turn or leave that line.
TEST(Swimmer, KeepsToADiagonal) {
  const Vec3 d = displacement(Vec3(1, 1, 0).normalized(), 1.3);
  EXPECT_NEAR(d[0], d[1], roundoff);
  EXPECT_NEAR(d[2], 0, roundoff);
}

// A fluid bead swarm stays at rest unless driven: no spurious forces from static coverage.
TEST(Swimmer, StaysAtRestUndriven) {
  const Communicator self(MPI_COMM_SELF);
  CoupledScene scene = small_swimmer(Index3::Constant(box_edge), Vec3(11.3, 12.1, 12.9), Vec3::UnitX());
  scene.types[0].driving.amplitude = {0, 0};
  CoupledSystem system(scene, self);
  advance(system, 50);
  EXPECT_EQ(system.owned_swimmers()[0].motion[2].position, Vec3(11.3 + 7, 12.1, 12.9));
}

TEST(Beads, ThatOverlapAreRefused) {
  const Communicator self(MPI_COMM_SELF);
  CoupledScene scene = small_swimmer(Index3::Constant(box_edge), Vec3::Constant(12), Vec3::UnitX());
  scene.types[0].springs.fill({.stiffness = 1, .rest_length = 3, .damping = 0});
  EXPECT_THROW(CoupledSystem(scene, self), SolverError);
}

TEST(Arms, ThatAreTornStopTheRun) {
  const Communicator self(MPI_COMM_SELF);
  CoupledScene scene = small_swimmer(Index3(64, 16, 16), Vec3(32, 8, 8), Vec3::UnitX());
  scene.types[0].springs.fill({.stiffness = 0, .rest_length = 7, .damping = 0});
  scene.types[0].driving = {{0, 3}, 0, 1e4, DrivingFrame::lab};
  scene.types[0].driving.phase = 1.57;
  CoupledSystem system(scene, self);
  EXPECT_THROW(advance(system, 400), SolverError);
}

}  // namespace
}  // namespace beadswim::test
