#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

#include "../three_bead_types.hpp"
#include "beadswim/overdamped/overdamped_system.hpp"

namespace beadswim {

constexpr double pi = std::numbers::pi;

/// Returns the single swimmer of the paper (Pickl et al. 2017) in lattice units, with T = 4800, A = B = 0.2
/// and the angular stiffness 10 k l^2.
inline ThreeBeadSwimmer paper_swimmer() {
  const Spring spring{.stiffness = 0.0347, .rest_length = 20, .damping = 0};
  const Bead bead{.radius = 4, .density = 1};
  return {.beads = {bead, bead, bead},
          .springs = {spring, spring},
          .angular_stiffness = 10 * 0.0347 * 400,
          .driving = {.amplitude = {0.2, 0.2}, .phase = pi / 2, .period = 4800}};
}

/// Returns a swimmer with dashpots in which all parameters that may differ are different.
inline ThreeBeadSwimmer odd_swimmer() {
  ThreeBeadSwimmer type = paper_swimmer();
  type.beads[0].radius = 3;
  type.beads[2].radius = 5;
  type.springs[0] = {.stiffness = 0.03, .rest_length = 16, .damping = 20};
  type.springs[1] = {.stiffness = 0.05, .rest_length = 22, .damping = 5};
  type.driving.amplitude = {0.15, 0.25};
  type.driving.phase = 1;
  type.driving.phase_offset = 0.4;
  return type;
}

inline OverdampedScene scene_of(const ThreeBeadSwimmer& type, int steps_per_cycle) {
  OverdampedScene scene;
  scene.viscosity = 1.0 / 3;
  scene.types = {swimmer_type(type)};
  scene.swimmers = {{.id = 0, .type = 0, .position = {60, 40, 40}}};
  scene.step = type.driving.period / steps_per_cycle;
  scene.tolerance = 1e-9;
  return scene;
}

/// Returns three swimmers of the paper in open space, rotated and close to each other. They have the stiff
/// angular springs of the presets. The driving along x bends them; bending relaxes 400 times within one
/// cycle.
inline OverdampedScene turned_swimmers() {
  OverdampedScene scene = scene_of(paper_swimmer(), 1);
  scene.swimmers[0].orientation = shortest_turn(Vec3(3, 1, 0).normalized());
  scene.swimmers.push_back({.id = 1,
                            .type = 0,
                            .position = {62, 54, 44},
                            .orientation = shortest_turn(Vec3(1, 0.5, -0.2).normalized())});
  scene.swimmers.push_back({.id = 2,
                            .type = 0,
                            .position = {40, 45, 58},
                            .orientation = shortest_turn(Vec3(-0.3, 1, 0.4).normalized())});
  return scene;
}

/// Returns the swimmer of the paper's swarms, as in their presets: radius 6, arms 32, A = B = 2, T = 2000.
inline ThreeBeadSwimmer swarm_swimmer() {
  ThreeBeadSwimmer type = paper_swimmer();
  for (Bead& bead : type.beads) bead.radius = 6;
  for (Spring& spring : type.springs) spring = {.stiffness = 0.2, .rest_length = 32, .damping = 0};
  type.angular_stiffness = 10 * 0.2 * 32 * 32;
  type.driving.amplitude = {2, 2};
  type.driving.period = 2000;
  return type;
}

/// Returns parallel swimmers along x in a periodic box. `rows`: number of swimmers along y and z. `distance`:
/// distance of neighbouring axes. Along x there is one swimmer, whose end beads have the distance 32 from
/// their images.
inline OverdampedScene lattice_of(std::array<int, 2> rows, double distance, int steps_per_cycle) {
  OverdampedScene scene = scene_of(swarm_swimmer(), steps_per_cycle);
  scene.tolerance = 1e-6;
  scene.domain.box = Box{{96, rows[0] * distance, rows[1] * distance}, {}};
  scene.swimmers.clear();
  for (int id = 0; id < rows[0] * rows[1]; ++id) {
    const Vec3 middle(48, (id % rows[0] + 0.5) * distance, (id / rows[0] + 0.5) * distance);
    scene.swimmers.push_back({.id = id, .type = 0, .position = middle});
  }
  return scene;
}

/// Rotates each swimmer by a different angle of up to about 0.03, and displaces it by a different vector of
/// up to about 0.5.
inline void disturb(OverdampedScene& scene) {
  for (PlacedSwimmer& swimmer : scene.swimmers) {
    const double s = 1 + swimmer.id;
    swimmer.orientation = shortest_turn(Vec3(1, 0.02 * std::sin(2 * s), 0.02 * std::cos(3 * s)).normalized());
    swimmer.position += 0.5 * Vec3(std::sin(5 * s), std::sin(7 * s), std::cos(11 * s));
  }
}

/// Returns the positions of all beads after this number of steps, on all ranks.
inline std::vector<Vec3> positions_after(const OverdampedScene& scene, int steps) {
  const Communicator world(MPI_COMM_WORLD);
  OverdampedSystem system(scene, world);
  for (int n = 0; n < steps; ++n) system.step();
  return {system.positions().begin(), system.positions().end()};
}

/// Returns the largest distance between the positions of the same bead in `a` and `b`.
inline double farthest(const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
  double most = 0;
  for (std::size_t i = 0; i < a.size(); ++i) most = std::max(most, (a[i] - b[i]).norm());
  return most;
}

}  // namespace beadswim
