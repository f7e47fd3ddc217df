#pragma once

#include <span>
#include <vector>

#include "beadswim/core/vec3.hpp"
#include "beadswim/scene/layout.hpp"
#include "beadswim/swimmers/swimmer_type.hpp"

// Swimmers with their types, in the form that all models of motion use. Quantities are in any coherent unit
// system.

namespace beadswim {

/// A swimmer at the start of a run.
struct PlacedSwimmer {
  int id = 0;
  int type = 0;                  ///< index into Swarm::types
  Vec3 position = Vec3::Zero();  ///< origin of the type's frame, unwrapped [length]
  Eigen::Matrix3d orientation = Eigen::Matrix3d::Identity();
  std::vector<Vec3> start{};  ///< centres of the beads, unwrapped [length]; empty: as at_start() has them
};

/// Swimmers and the types that they share.
struct Swarm {
  std::vector<SwimmerType> types;
  std::vector<PlacedSwimmer> swimmers;

  const SwimmerType& type_of(const PlacedSwimmer& swimmer) const { return types[swimmer.type]; }
};

/// Return the layout's swimmers in its order, or sorted by id. A swimmer with its own driving has its own
/// type in the result.
Swarm listed_swimmers(const Layout& layout);
Swarm placed_swimmers(const Layout& layout);

/// Beads [first, last) of one swimmer in a list of all beads.
struct BeadRange {
  std::size_t first = 0, last = 0;
};

/// Returns the beads of each swimmer in lists of all beads in order of the swimmers.
std::vector<BeadRange> bead_ranges(const Swarm& swarm);

/// Returns the centres of all beads at the start [length], in order of the swimmers.
std::vector<Vec3> start_positions(const Swarm& swarm);

/// Returns the radii of all beads [length], in the order of start_positions.
std::vector<double> bead_radii(const Swarm& swarm);

/// Returns the largest radius of all beads of the types [length].
double largest_radius(std::span<const SwimmerType> types);

}  // namespace beadswim
