#pragma once

#include <gtest/gtest.h>

#include "beadswim/collinear/oseen.hpp"
#include "beadswim/collinear/rotne_prager.hpp"
#include "beadswim/theory/box_mobility.hpp"
#include "beadswim/theory/periodic_motion.hpp"
#include "beadswim/theory/question.hpp"
#include "scenes.hpp"

namespace beadswim {

struct Swimming {
  double velocity;
  std::array<double, 2> arm_means;
};

/// Returns velocity and stroke in the last of `cycles` cycles, in which strokes are periodic.
inline Swimming swimming_of(const OverdampedScene& scene, int steps_per_cycle, int cycles) {
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

inline PeriodicMotion theory_of(const OverdampedScene& scene) {
  const CollinearSwimmer swimmer =
      collinear_swimmer(three_beads(scene.types[0]), Vec3::UnitX(), scene.viscosity);
  if (scene.model == MobilityModel::rpy_near)
    return periodic_motion(swimmer, rest_positions(swimmer),
                           [&](const LinePositions& x) { return exact_mobility(swimmer, x, 1e-9); });
  const PairLaw law = scene.model == MobilityModel::oseen ? oseen : rotne_prager;
  if (!scene.domain.box) {
    return periodic_motion(swimmer, rest_positions(swimmer), [&](const LinePositions& x) {
      return pairwise_mobility(law, swimmer.radius, x, scene.viscosity);
    });
  }
  const LineFlow flow(scene.viscosity, *scene.domain.box, scene.swimmers[0].position[1],
                      scene.swimmers[0].position[2]);
  LinePositions rest = rest_positions(swimmer);
  for (double& x : rest) x += scene.swimmers[0].position[0];
  return periodic_motion(swimmer, rest,
                         [&](const LinePositions& x) { return rotne_prager_mobility(flow, swimmer, x); });
}

inline void expect_theory(const OverdampedScene& scene, int steps_per_cycle, int cycles, double truncation) {
  const Swimming run = swimming_of(scene, steps_per_cycle, cycles);
  const PeriodicMotion theory = theory_of(scene);
  EXPECT_NEAR(run.velocity / theory.velocity, 1, truncation);
  for (int arm = 0; arm < 2; ++arm)
    EXPECT_NEAR(run.arm_means[arm] / (scene.types[0].bonds[arm].rest_length + theory.arm_changes[arm]), 1,
                truncation)
        << "arm " << arm + 1;
}

}  // namespace beadswim
