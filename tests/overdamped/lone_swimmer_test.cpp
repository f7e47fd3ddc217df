#include <gtest/gtest.h>

#include <cmath>

#include "beadswim/mobility/oseen.hpp"
#include "beadswim/mobility/rotne_prager.hpp"
#include "beadswim/theory/box_mobility.hpp"
#include "beadswim/theory/periodic_motion.hpp"
#include "beadswim/theory/question.hpp"
#include "scenes.hpp"

namespace beadswim {
namespace {

struct Swimming {
  double velocity;
  std::array<double, 2> arm_means;
};

/// Of the last of some cycles, at which strokes are periodic.
Swimming swimming_of(const OverdampedScene& scene, int steps_per_cycle, int cycles) {
  const Communicator world(MPI_COMM_WORLD);
  OverdampedSystem system(scene, world);
  const auto centre = [&] {
    return (system.positions()[0] + system.positions()[1] + system.positions()[2])[0] / 3;
  };
  Swimming result{};
  for (int n = 0; n < cycles * steps_per_cycle; ++n) {
    if (n >= (cycles - 1) * steps_per_cycle)
      for (int arm = 0; arm < 2; ++arm)
        result.arm_means[arm] +=
            (system.positions()[arm + 1] - system.positions()[arm]).norm() / steps_per_cycle;
    if (n == (cycles - 1) * steps_per_cycle) result.velocity = -centre();
    system.step();
  }
  result.velocity = (result.velocity + centre()) / scene.types[0].driving.period;
  return result;
}

PeriodicMotion theory_of(const OverdampedScene& scene) {
  const CollinearSwimmer swimmer = collinear_swimmer(scene.types[0], Vec3::UnitX(), scene.viscosity);
  if (scene.model == PointModel::rotne_prager_near)
    return periodic_motion(swimmer, rest_positions(swimmer),
                           [&](const LinePositions& x) { return exact_mobility(swimmer, x, 1e-9); });
  const PairLaw law = scene.model == PointModel::oseen ? oseen : rotne_prager;
  if (!scene.box) {
    return periodic_motion(swimmer, rest_positions(swimmer), [&](const LinePositions& x) {
      return pairwise_mobility(law, swimmer.radius, x, scene.viscosity);
    });
  }
  const LineFlow flow(scene.viscosity, *scene.box, scene.swimmers[0].position[1],
                      scene.swimmers[0].position[2]);
  LinePositions rest = rest_positions(swimmer);
  for (double& x : rest) x += scene.swimmers[0].position[0];
  return periodic_motion(swimmer, rest,
                         [&](const LinePositions& x) { return rotne_prager_in(flow, swimmer, x); });
}

void expect_theory(const OverdampedScene& scene, int steps_per_cycle, int cycles, double truncation) {
  const Swimming run = swimming_of(scene, steps_per_cycle, cycles);
  const PeriodicMotion theory = theory_of(scene);
  EXPECT_NEAR(run.velocity / theory.velocity, 1, truncation);
  for (int arm = 0; arm < 2; ++arm)
    EXPECT_NEAR(run.arm_means[arm] / theory.arm_means[arm], 1, truncation) << "arm " << arm + 1;
}

// Harmonic balance knows no steps, and has its own mobilities along a line.
TEST(OverdampedSwimmer, SwimsAsHarmonicBalanceSaysInOpenSpace) {
  constexpr int steps = 1000;
  constexpr double truncation = 1e-6;
  for (const PointModel model : {PointModel::rotne_prager, PointModel::oseen}) {
    for (const SwimmerType& type : {paper_swimmer(), odd_swimmer()}) {
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
    for (SwimmerType type : {paper_swimmer(), odd_swimmer()}) {
      type.springs[0].rest_length = arm;
      type.springs[1].rest_length = 1.1 * arm;
      OverdampedScene scene = scene_of(type, steps);
      scene.model = PointModel::rotne_prager_near;
      SCOPED_TRACE(testing::Message() << "arm " << arm << ", radius " << type.beads[0].radius);
      expect_theory(scene, steps, 8, truncation);
    }
  }
}

// Ewald's sum along the line against that in space; a swimmer between walls across its axis feels their
// images.
TEST(OverdampedSwimmer, SwimsAsHarmonicBalanceSaysInBoxes) {
  constexpr int steps = 300;
  constexpr double truncation = 5e-5;
  OverdampedScene scene = scene_of(paper_swimmer(), steps);
  scene.tolerance = 1e-6;
  scene.box = Box{{120, 80, 80}, {}};
  expect_theory(scene, steps, 3, truncation);
  scene.box = Box{{100, 40, 40}, {false, true, false}};
  scene.swimmers[0].position = {50, 20, 20};
  expect_theory(scene, steps, 3, truncation);
}

// Quasi-static v/v_free of the paper's swimmer at small amplitude, by sums along a line.
TEST(OverdampedSwimmer, HasTheBoxFactorsOnRecord) {
  struct Case {
    Vec3 lengths;
    bool has_walls;
    double factor, printed_digits;
  };
  constexpr int steps = 100;
  SwimmerType type = paper_swimmer();
  type.driving.amplitude = {0.01, 0.01};
  OverdampedScene scene = scene_of(type, steps);
  scene.tolerance = 1e-8;  // the swimmer is a thousandth as fast as its beads
  const double open = swimming_of(scene, steps, 3).velocity;
  for (const auto& [lengths, has_walls, factor, printed_digits] :
       {Case{{60, 60, 60}, false, 1.3228, 1e-4}, Case{{100, 100, 100}, false, 1.0287, 1e-4},
        Case{{100, 40, 40}, false, 0.768, 1e-3}, Case{{160, 80, 80}, true, 0.99226, 1e-4}}) {
    scene.box = Box{{lengths[0], lengths[1], lengths[2]}, {has_walls, has_walls, has_walls}};
    scene.swimmers[0].position = lengths / 2;
    EXPECT_NEAR(swimming_of(scene, steps, 3).velocity / open, factor, printed_digits) << lengths.transpose();
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
  scene.swimmers[0].axis = Vec3(3, 1, 0).normalized();  // the driving along x bends it
  const auto soft = positions_after(scene, 120);
  scene.types[0].angular_stiffness *= 1e4;
  const auto stiff = positions_after(scene, 120);
  for (int b = 0; b < 3; ++b) EXPECT_LT((stiff[b] - soft[b]).norm(), 0.1) << "bead " << b + 1;
  const Vec3 first = stiff[1] - stiff[0], second = stiff[2] - stiff[1];
  EXPECT_LT(first.cross(second).norm(), 1e-5 * first.norm() * second.norm());
}

// The driving would bring beads together: they stay apart, and the run goes on.
TEST(OverdampedSwimmer, KeepsDrivenBeadsApart) {
  OverdampedScene scene = scene_of(paper_swimmer(), 200);
  for (Spring& spring : scene.types[0].springs) spring.rest_length = 14;
  scene.types[0].driving.amplitude = {0.4, 0.4};
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
    second.restore(first.state());
    for (int n = until; n < 40; ++n) second.step();
    for (int b = 0; b < 3; ++b)
      EXPECT_EQ(whole.positions()[b], second.positions()[b]) << "bead " << b + 1 << " from " << until;
  }
}

}  // namespace
}  // namespace beadswim
