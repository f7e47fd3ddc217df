#include <gtest/gtest.h>

#include <cmath>

#include "swimming.hpp"

namespace beadswim {
namespace {

// Harmonic balance knows no steps, and has its own mobilities along a line.
TEST(OverdampedSwimmer, SwimsAsHarmonicBalanceSaysInOpenSpace) {
  constexpr int steps = 1000;
  constexpr double truncation = 1e-6;
  for (const MobilityModel model : {MobilityModel::rpy, MobilityModel::oseen}) {
    for (const ThreeBeadSwimmer& type : {paper_swimmer(), odd_swimmer()}) {
      OverdampedScene scene = scene_of(type, steps);
      scene.model = model;
      expect_theory(scene, steps, 8, truncation);
    }
  }
}

// Exact Stokes flow of three spheres by harmonic balance, from arms of 8 radii to beads 1.2 radii apart: with
// Rotne and Prager's mobility the speed is 3 to 28 % high at equal arms of 8 to 4 radii.
TEST(OverdampedSwimmer, SwimsAsExactStokesFlowSaysWithNearFields) {
  constexpr int steps = 1000;
  constexpr double truncation = 2e-6;
  for (const double arm : {12.8, 16.0, 20.0, 32.0}) {
    for (ThreeBeadSwimmer type : {paper_swimmer(), odd_swimmer()}) {
      type.springs[0].rest_length = arm;
      type.springs[1].rest_length = 1.1 * arm;
      OverdampedScene scene = scene_of(type, steps);
      scene.model = MobilityModel::rpy_near;
      SCOPED_TRACE(testing::Message() << "arm " << arm << ", radius " << type.beads[0].radius);
      expect_theory(scene, steps, 8, truncation);
    }
  }
}

// Positions at the end of a quarter cycle: slope 3 over three steps, to 1e-6 of the stroke.
TEST(OverdampedSwimmer, ConvergesWithTheCubeOfTheStep) {
  OverdampedScene scene = scene_of(odd_swimmer(), 1);
  scene.tolerance = 1e-12;
  const double period = scene.types[0].driving.period;
  const auto end = [&](int steps_per_cycle) {
    scene.step = period / steps_per_cycle;
    return positions_after(scene, steps_per_cycle / 4)[0][0];
  };
  const double exact = end(6400);
  const double coarse = std::abs(end(400) - exact), middle = std::abs(end(800) - exact),
               fine = std::abs(end(1600) - exact);
  EXPECT_NEAR(std::log2(coarse / middle), 3, 0.4);
  EXPECT_NEAR(std::log2(middle / fine), 3, 0.4);
  EXPECT_LT(fine, 1e-5);
}

// Angular springs that relax within a hundredth of a step are solved for; steps stay as few.
TEST(OverdampedSwimmer, BearsStiffAngularSprings) {
  OverdampedScene scene = scene_of(paper_swimmer(), 60);
  scene.swimmers[0].orientation = shortest_turn(Vec3(3, 1, 0).normalized());  // the driving along x bends it
  const auto soft = positions_after(scene, 120);
  scene.types[0].angles[0].stiffness *= 1e4;
  const auto stiff = positions_after(scene, 120);
  for (int b = 0; b < 3; ++b) EXPECT_LT((stiff[b] - soft[b]).norm(), 0.1) << "bead " << b + 1;
  const Vec3 first = stiff[1] - stiff[0], second = stiff[2] - stiff[1];
  EXPECT_LT(first.cross(second).norm(), 1e-5 * first.norm() * second.norm());
}

// The driving would bring beads together: they stay apart, and the run goes on.
TEST(OverdampedSwimmer, KeepsDrivenBeadsApart) {
  ThreeBeadSwimmer type = paper_swimmer();
  for (Spring& spring : type.springs) spring.rest_length = 14;
  type.driving.amplitude = {0.4, 0.4};
  OverdampedScene scene = scene_of(type, 200);
  const Communicator world(MPI_COMM_WORLD);
  OverdampedSystem system(scene, world);
  for (int n = 0; n < 600; ++n) {
    system.step();
    ASSERT_FALSE(system.fault()) << "step " << n << ", kind " << static_cast<int>(system.fault()->kind)
                                 << ", " << system.fault()->value;
  }
  EXPECT_GT(system.state().smallest_gap, 0);
  EXPECT_LT(system.state().smallest_gap, 0.8);
}

// The same state, the same bits, from the first steps on.
TEST(OverdampedSwimmer, GoesOnFromAState) {
  const OverdampedScene scene = scene_of(odd_swimmer(), 100);
  const Communicator world(MPI_COMM_WORLD);
  OverdampedSystem whole(scene, world);
  for (int n = 0; n < 40; ++n) whole.step();
  for (const int until : {0, 1, 2, 25}) {
    OverdampedSystem first(scene, world), second(scene, world);
    for (int n = 0; n < until; ++n) first.step();
    second.restore(first.state(), {});
    for (int n = until; n < 40; ++n) second.step();
    for (int b = 0; b < 3; ++b)
      EXPECT_EQ(whole.positions()[b], second.positions()[b]) << "bead " << b + 1 << " from " << until;
  }
}

// A restart changes neither the steps at which the mobility of oseen is checked nor the mode from which a
// check begins, so that it reports the same fault. The first bead sinks to 9/8 radii over a wall, where the
// mobility vanishes; the second one hardly moves, so that it is checked every 100 steps.
TEST(OverdampedSwimmer, IsCheckedAlikeAfterARestart) {
  struct Case {
    double force;
    int until, steps;
    bool sinks;
  };
  for (const auto& [force, until, steps, sinks] : {Case{12, 3, 20, true}, Case{1e-6, 160, 260, false}}) {
    SwimmerType type;
    type.beads = {{{.radius = 1, .density = 1}, Vec3::Zero()}};
    type.driving.period = 10;
    type.driving.forces = {{.bead = 0, .direction = -Vec3::UnitZ(), .constant = force}};
    OverdampedScene scene;
    scene.model = MobilityModel::oseen;
    scene.viscosity = 0.15;
    scene.types = {type};
    scene.swimmers = {{.id = 0, .type = 0, .position = {0, 0, 1.6}}};
    scene.domain.half_space = HalfSpace{2};
    scene.step = 0.25;
    const Communicator world(MPI_COMM_WORLD);
    OverdampedSystem whole(scene, world), restarted(scene, world);
    for (int n = 0; n < until; ++n) whole.step();
    ASSERT_FALSE(whole.fault());
    restarted.restore(whole.state(), {});
    for (int n = until; n < steps; ++n) {
      whole.step();
      restarted.step();
      EXPECT_EQ(whole.state().checked_steps, restarted.state().checked_steps) << n;
      EXPECT_EQ(whole.state().lowest_mode, restarted.state().lowest_mode) << n;
    }
    ASSERT_EQ(whole.fault().has_value(), sinks);
    ASSERT_EQ(restarted.fault().has_value(), sinks);
    if (!sinks) continue;
    EXPECT_EQ(whole.fault()->kind, FaultKind::not_positive);
    EXPECT_EQ(restarted.fault()->kind, FaultKind::not_positive);
    EXPECT_EQ(whole.fault()->step, restarted.fault()->step);
  }
}

}  // namespace
}  // namespace beadswim
