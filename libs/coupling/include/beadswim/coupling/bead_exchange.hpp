#pragma once

#include <map>
#include <optional>
#include <span>
#include <vector>

#include "beadswim/core/communicator.hpp"
#include "beadswim/core/traffic.hpp"
#include "beadswim/coupling/bead_images.hpp"
#include "beadswim/coupling/bead_on_lattice.hpp"
#include "beadswim/coupling/fault.hpp"
#include "beadswim/coupling/scene.hpp"
#include "beadswim/coupling/swimmer_state.hpp"

namespace beadswim {

/// Gap between a bead and a wall below which the first cells along the wall would be covered [cell].
constexpr double nearest_to_wall = 0.5;

/// An arm longer than this many rest lengths is torn.
constexpr double longest_stretch = 2;

/// Messages between the rank that owns a swimmer and those whose cells its beads touch.
///
/// The rank whose block holds bead 2 owns the swimmer. Each step it tells the ranks near its beads where they
/// are (publish), and these return what their cells handed to the beads (collect). Ranks talk to a fixed set
/// of peers, those within the reach of a swimmer's arms; nothing is global.
class BeadExchange {
 public:
  BeadExchange(const Communicator& communicator, const Decomposition& decomposition,
               const CoupledScene& scene);

  /// Rank whose block holds a point given in unwrapped coordinates.
  int owner_of(const Vec3& position) const;

  /// What forbids to publish a swimmer: an arm longer than longest_stretch times its rest length, as its
  /// owner would no longer reach the ranks that its beads touch, or a bead nearer than nearest_to_wall to
  /// one. The fault's step is not set.
  std::optional<Fault> out_of_reach(const SwimmerState& swimmer) const;

  /// Hands swimmers whose bead 2 has left the block to their new owners, and returns the beads near this
  /// block, in order of their names.
  std::vector<BeadOnLattice> publish(std::vector<SwimmerState>& owned);

  /// Sent so far.
  const Traffic& traffic() const { return traffic_; }

  /// Ranks that it talks to, itself among them.
  const std::vector<int>& peers() const { return peers_; }

  /// Returns this rank's impulses to the owners; the totals of owned swimmers' beads come back.
  std::map<BeadName, Impulse> collect(std::span<const BeadOnLattice> beads);

 private:
  using Buffers = std::vector<std::vector<char>>;  ///< one a peer

  std::vector<char> announcement(const std::vector<SwimmerState>& owned, int peer) const;
  Buffers exchange(const Buffers& to_peers, int tag);

  MPI_Comm comm_;
  int rank_;
  Decomposition decomposition_;
  std::vector<BlockInLattice> blocks_;  ///< of all ranks
  std::vector<int> peers_;
  Traffic traffic_;
  const std::vector<SwimmerType>& types_;
  std::vector<std::array<double, 3>> radii_;  ///< on the lattice, of each type
};

}  // namespace beadswim
