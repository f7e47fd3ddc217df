#pragma once

#include <optional>
#include <span>
#include <vector>

#include "beadswim/compare/cycle_statistics.hpp"
#include "beadswim/core/box.hpp"
#include "beadswim/core/fields.hpp"
#include "beadswim/core/vec3.hpp"

// Motion and order of a swarm at the end of a base cycle. A base cycle is one period of the driving; if the
// periods of the swimmers differ, it is one period of the type of the first swimmer. Angle brackets <...>
// denote the mean over the swimmers. See docs/method/swarm-statistics.md.

namespace beadswim {

/// State of one swimmer of a swarm at one time.
struct SwarmMember {
  Vec3 centre = Vec3::Zero();                 ///< mean position of the bead centres, unwrapped [length]
  Vec3 axis = Vec3::UnitX();                  ///< unit vector from bead 1 to bead 3
  Vec3 initial_axis = Vec3::UnitX();          ///< axis at the start of the run
  double kinetic_energy = 0;                  ///< kinetic energy of the beads [energy]
  std::optional<CycleStatistics> last_cycle;  ///< last complete cycle of its own driving; empty if none
};

/// Distribution of one quantity over swimmers with equal weights, in the unit of the quantity.
struct Spread {
  double mean = 0;
  double deviation = 0;  ///< population standard deviation: root of the mean squared difference from the mean
  double smallest = 0, largest = 0;

  BEADSWIM_FIELDS(mean, deviation, smallest, largest)
};

/// Motion of the swimmers of a swarm, each in its last complete cycle.
struct SwarmSwimming {
  int swimmers = 0;                        ///< number of swimmers with a complete cycle, at least 1
  Vec3 velocity = Vec3::Zero();            ///< mean velocity in the frame of the box [length/time]
  Vec3 velocity_deviation = Vec3::Zero();  ///< standard deviation of each velocity component [length/time]
  Spread speed_along_axis;                 ///< velocity of each swimmer along its own axis [length/time]
  Vec3 mean_flow = Vec3::Zero();           ///< mean of CycleStatistics::mean_flow over swimmers [length/time]
  /// d1, d2, ... of equation (4.1) of the paper [length]; each over the swimmers that have this arm
  std::vector<Spread> arm_amplitudes;
  std::vector<Spread> arm_means;  ///< mean arm lengths [length]
  std::optional<Spread> power;    ///< mean power of the driving [mass length^2/time^3]; empty if not known
  std::vector<double> arm_phase_order;  ///< Kuramoto |<exp(i delta)>| of each arm; 1: equal phases

  BEADSWIM_FIELDS(swimmers, velocity, velocity_deviation, speed_along_axis, mean_flow, arm_amplitudes,
                  arm_means, (power, omitted_if_none), arm_phase_order)
};

/// State of a swarm at the end of a base cycle.
struct SwarmStatistics {
  int index = 0;                          ///< number of the base cycle, 1 for the first
  int swimmers = 0;                       ///< number of all swimmers
  std::optional<SwarmSwimming> swimming;  ///< empty until a swimmer has completed a cycle
  Vec3 mean_axis = Vec3::Zero();          ///< <axis>, mean of the axes of all swimmers
  double polar_order = 0;                 ///< length of mean_axis; 1: all axes are equal
  double nematic_order = 0;               ///< S, largest eigenvalue of <(3 axis axis - 1)/2>; 1: all parallel
  Vec3 director = Vec3::Zero();           ///< unit eigenvector to S, with its largest component > 0
  Spread rotation;                        ///< angle between axis and initial axis, in [0, pi] [rad]
  std::optional<Spread> nearest_neighbour;  ///< distance to nearest swimmer [length]; empty if there is none
  double kinetic_energy = 0;                ///< kinetic energy of all beads [energy]

  BEADSWIM_FIELDS(index, swimmers, swimming, mean_axis, polar_order, nematic_order, director, rotation,
                  nearest_neighbour, kinetic_energy)
};

/// Evaluates the statistics of a swarm at the end of base cycle `index`. Distances to nearest neighbours are
/// between swimmer centres, periodic images included (nearest_neighbours.hpp). All swimmers have equal
/// weight, so that the order of `members` affects the result only by roundoff. Without members, all results
/// are zero or empty.
SwarmStatistics swarm_statistics(int index, std::span<const SwarmMember> members,
                                 const std::optional<Box>& box);

}  // namespace beadswim
