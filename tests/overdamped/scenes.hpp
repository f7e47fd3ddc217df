#pragma once

#include <numbers>

#include "beadswim/overdamped/overdamped_system.hpp"

namespace beadswim {

constexpr double pi = std::numbers::pi;

/// The paper's swimmer at T = 4800 and A = B = 0.2, in its lattice units, its angular spring 10 k l^2.
inline SwimmerType paper_swimmer() {
  const Spring spring{.stiffness = 0.0347, .rest_length = 20, .damping = 0};
  const Bead bead{.radius = 4, .density = 1};
  return {.beads = {bead, bead, bead},
          .springs = {spring, spring},
          .angular_stiffness = 10 * 0.0347 * 400,
          .driving = {.amplitude = {0.2, 0.2}, .phase = pi / 2, .period = 4800}};
}

/// Unequal in all that may be, with dashpots.
inline SwimmerType odd_swimmer() {
  SwimmerType type = paper_swimmer();
  type.beads[0].radius = 3;
  type.beads[2].radius = 5;
  type.springs[0] = {.stiffness = 0.03, .rest_length = 16, .damping = 20};
  type.springs[1] = {.stiffness = 0.05, .rest_length = 22, .damping = 5};
  type.driving.amplitude = {0.15, 0.25};
  type.driving.phase = 1;
  type.driving.phase_offset = 0.4;
  return type;
}

inline OverdampedScene scene_of(const SwimmerType& type, int steps_per_cycle) {
  return {.model = PointModel::rotne_prager,
          .viscosity = 1.0 / 3,
          .box = {},
          .types = {type},
          .swimmers = {{.id = 0, .type = 0, .position = {60, 40, 40}, .axis = Vec3::UnitX()}},
          .step = type.driving.period / steps_per_cycle,
          .tolerance = 1e-9};
}

/// Positions after so many steps, the same on all ranks.
inline std::vector<Vec3> positions_after(const OverdampedScene& scene, int steps) {
  const Communicator world(MPI_COMM_WORLD);
  OverdampedSystem system(scene, world);
  for (int n = 0; n < steps; ++n) system.step();
  return {system.positions().begin(), system.positions().end()};
}

}  // namespace beadswim
