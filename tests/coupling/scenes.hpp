#pragma once

#include <numbers>

#include "../three_bead_types.hpp"
#include "beadswim/coupling/coupled_system.hpp"
#include "beadswim/coupling/scene.hpp"

namespace beadswim::test {

/// Returns a scene of one small, strongly driven swimmer in a periodic box: bead radius 2 cells, arms 7
/// cells.
inline CoupledScene small_swimmer(const Index3& cells, const Vec3& position, const Vec3& axis) {
  ThreeBeadSwimmer type;
  type.beads.fill({.radius = 2.2, .density = 1});
  type.springs.fill({.stiffness = 0.05, .rest_length = 7, .damping = 0});
  type.angular_stiffness = 25;
  type.driving = {.amplitude = {0.4, 0.4},
                  .phase = std::numbers::pi / 2,
                  .period = 120,
                  .frame = DrivingFrame::initial_axis};
  CoupledScene scene;
  scene.cells = cells;
  scene.relaxation_time = 1.2;
  scene.types = {swimmer_type(type)};
  scene.swimmers = {{.id = 0, .type = 0, .position = position, .orientation = shortest_turn(axis)}};
  return scene;
}

/// Returns a type of one sphere, which nothing drives.
inline SwimmerType sphere_type(double radius) {
  SwimmerType type;
  BeadAtRest& bead = type.beads.emplace_back();
  bead.radius = radius;
  bead.density = 1;
  bead.at.setZero();
  type.driving.period = 100;
  return type;
}

inline void advance(CoupledSystem& system, int steps) {
  for (int n = 0; n < steps; ++n) system.step();
}

}  // namespace beadswim::test
