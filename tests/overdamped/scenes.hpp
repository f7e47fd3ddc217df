#pragma once

#include <algorithm>
#include <cmath>
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
  OverdampedScene scene;
  scene.viscosity = 1.0 / 3;
  scene.types = {type};
  scene.swimmers = {{.id = 0, .type = 0, .position = {60, 40, 40}, .axis = Vec3::UnitX()}};
  scene.step = type.driving.period / steps_per_cycle;
  scene.tolerance = 1e-9;
  return scene;
}

/// Three of the paper's swimmers in open space, turned and near each other, with the presets' stiff angular
/// springs: the driving along x bends them, and bending relaxes 400 times in a cycle.
inline OverdampedScene turned_swimmers() {
  OverdampedScene scene = scene_of(paper_swimmer(), 1);
  scene.swimmers[0].axis = Vec3(3, 1, 0).normalized();
  scene.swimmers.push_back(
      {.id = 1, .type = 0, .position = {62, 54, 44}, .axis = Vec3(1, 0.5, -0.2).normalized()});
  scene.swimmers.push_back(
      {.id = 2, .type = 0, .position = {40, 45, 58}, .axis = Vec3(-0.3, 1, 0.4).normalized()});
  return scene;
}

/// The swimmer of the paper's swarms, by their presets: radius 6, arms 32, A = B = 2, T = 2000.
inline SwimmerType swarm_swimmer() {
  SwimmerType type = paper_swimmer();
  for (Bead& bead : type.beads) bead.radius = 6;
  for (Spring& spring : type.springs) spring = {.stiffness = 0.2, .rest_length = 32, .damping = 0};
  type.angular_stiffness = 10 * 0.2 * 32 * 32;
  type.driving.amplitude = {2, 2};
  type.driving.period = 2000;
  return type;
}

/// So many rows of swimmers along y and z, a distance apart across them, in the periodic box that they fill;
/// along x, the swimmers' axis, one, its end beads 32 from its images'.
inline OverdampedScene lattice_of(std::array<int, 2> rows, double distance, int steps_per_cycle) {
  OverdampedScene scene = scene_of(swarm_swimmer(), steps_per_cycle);
  scene.tolerance = 1e-6;
  scene.box = Box{{96, rows[0] * distance, rows[1] * distance}, {}};
  scene.swimmers.clear();
  for (int id = 0; id < rows[0] * rows[1]; ++id) {
    const Vec3 middle(48, (id % rows[0] + 0.5) * distance, (id / rows[0] + 0.5) * distance);
    scene.swimmers.push_back({.id = id, .type = 0, .position = middle, .axis = Vec3::UnitX()});
  }
  return scene;
}

/// Turns swimmers by up to some 0.03 and moves them by up to 0.5, each differently.
inline void disturb(OverdampedScene& scene) {
  for (PlacedSwimmer& swimmer : scene.swimmers) {
    const double s = 1 + swimmer.id;
    swimmer.axis = Vec3(1, 0.02 * std::sin(2 * s), 0.02 * std::cos(3 * s)).normalized();
    swimmer.position += 0.5 * Vec3(std::sin(5 * s), std::sin(7 * s), std::cos(11 * s));
  }
}

/// Positions after so many steps, the same on all ranks.
inline std::vector<Vec3> positions_after(const OverdampedScene& scene, int steps) {
  const Communicator world(MPI_COMM_WORLD);
  OverdampedSystem system(scene, world);
  for (int n = 0; n < steps; ++n) system.step();
  return {system.positions().begin(), system.positions().end()};
}

/// Largest distance between places of the same beads.
inline double farthest(const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
  double most = 0;
  for (std::size_t i = 0; i < a.size(); ++i) most = std::max(most, (a[i] - b[i]).norm());
  return most;
}

}  // namespace beadswim
