#pragma once

#include <array>
#include <optional>
#include <span>

#include "beadswim/compare/cycle_statistics.hpp"
#include "beadswim/core/box.hpp"
#include "beadswim/core/vec3.hpp"

// How a swarm swims and stands at the end of a base cycle. See docs/method/swarm-statistics.md.

namespace beadswim {

/// One swimmer of a swarm at one time.
struct SwarmMember {
  Vec3 centre = Vec3::Zero();                 ///< mean of its bead centres, unwrapped [length]
  Vec3 axis = Vec3::UnitX();                  ///< unit vector from bead 1 to bead 3
  Vec3 initial_axis = Vec3::UnitX();          ///< the same at the start of the run
  double kinetic_energy = 0;                  ///< of its beads [energy]
  std::optional<CycleStatistics> last_cycle;  ///< last whole cycle of its own driving; none before one ended
};

/// How one quantity is spread over swimmers that count alike, in the quantity's unit.
struct Spread {
  double mean = 0;
  double deviation = 0;  ///< root of the mean squared difference from the mean (divided by N, not N - 1)
  double smallest = 0, largest = 0;

  static void visit_fields(auto&& visit, auto& spread) {
    visit("mean", spread.mean);
    visit("deviation", spread.deviation);
    visit("smallest", spread.smallest);
    visit("largest", spread.largest);
  }
};

/// How swimmers swam, each in its last cycle.
struct SwarmSwimming {
  int swimmers = 0;                         ///< that have a cycle, at least 1
  Vec3 velocity = Vec3::Zero();             ///< mean, in the frame of the box [length/time]
  Vec3 velocity_deviation = Vec3::Zero();   ///< of each component, as Spread::deviation [length/time]
  Spread speed_along_axis;                  ///< each along its own axis [length/time]
  Vec3 mean_flow = Vec3::Zero();            ///< mean over swimmers of that in their cycles [length/time]
  std::array<Spread, 2> arm_amplitudes{};   ///< d1, d2 of (4.1) [length]
  std::array<Spread, 2> arm_means{};        ///< mean arm lengths [length]
  std::array<double, 2> arm_phase_order{};  ///< Kuramoto |<exp(i delta)>| of delta1, delta2; 1: all in step

  static void visit_fields(auto&& visit, auto& swimming) {
    visit("swimmers", swimming.swimmers);
    visit("velocity", swimming.velocity);
    visit("velocity_deviation", swimming.velocity_deviation);
    visit("speed_along_axis", swimming.speed_along_axis);
    visit("mean_flow", swimming.mean_flow);
    visit("arm_amplitudes", swimming.arm_amplitudes);
    visit("arm_means", swimming.arm_means);
    visit("arm_phase_order", swimming.arm_phase_order);
  }
};

/// A swarm at the end of a base cycle.
struct SwarmStatistics {
  int index = 0;                          ///< 1 for the first base cycle
  int swimmers = 0;                       ///< all members, with a cycle or without
  std::optional<SwarmSwimming> swimming;  ///< none before a swimmer has ended a cycle
  Vec3 mean_axis = Vec3::Zero();          ///< <axis>; its direction is that of polar order
  double polar_order = 0;                 ///< |<axis>|; 1: all point the same way
  double nematic_order = 0;               ///< S, largest eigenvalue of <(3 axis axis - 1)/2>; 1: all parallel
  Vec3 director = Vec3::Zero();           ///< its unit eigenvector, of either sign: largest component > 0
  Spread rotation;                        ///< angle between axis and initial axis, in [0, pi]
  std::optional<Spread> nearest_neighbour;  ///< distance to it [length]; none for one swimmer without images
  double kinetic_energy = 0;                ///< of all beads [energy]

  static void visit_fields(auto&& visit, auto& swarm) {
    visit("index", swarm.index);
    visit("swimmers", swarm.swimmers);
    visit("swimming", swarm.swimming);
    visit("mean_axis", swarm.mean_axis);
    visit("polar_order", swarm.polar_order);
    visit("nematic_order", swarm.nematic_order);
    visit("director", swarm.director);
    visit("rotation", swarm.rotation);
    visit("nearest_neighbour", swarm.nearest_neighbour);
    visit("kinetic_energy", swarm.kinetic_energy);
  }
};

/// Statistics of a swarm at the end of base cycle `index`. Nearest neighbours are between centres and count
/// periodic images as nearest_neighbours.hpp has it. All swimmers count
/// alike, so that the order of members matters to roundoff only. Without members everything is zero or none.
SwarmStatistics swarm_statistics(int index, std::span<const SwarmMember> members,
                                 const std::optional<Box>& box);

}  // namespace beadswim
