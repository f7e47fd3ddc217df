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

/// Smallest permitted gap between a bead and a wall [cell]. With a smaller gap a bead can cover the cells
/// next to the wall.
constexpr double min_wall_gap = 0.5;

/// Largest permitted length of an arm [rest length]. A longer arm counts as torn.
constexpr double max_stretch = 2;

/// Exchanges messages between the rank that owns a swimmer and the ranks whose cells its beads touch.
///
/// The rank whose block contains bead 2 owns the swimmer. In each step the owner sends the beads to the ranks
/// near them (publish), and these ranks return the impulses that their cells have transferred to the beads
/// (collect). A rank communicates with a fixed set of peers: the ranks that the beads of its swimmers can
/// touch. There is no global communication.
class BeadExchange {
 public:
  BeadExchange(const Communicator& communicator, const Decomposition& decomposition,
               const CoupledScene& scene);

  /// Returns the rank whose block contains `position` (unwrapped coordinates [cell]).
  int owner_of(const Vec3& position) const;

  /// Returns the fault that forbids the publication of a swimmer, if there is one: an arm longer than
  /// max_stretch, whose beads may touch ranks that are no peers of the owner, or a bead nearer to a wall than
  /// min_wall_gap. The step of the fault is not set.
  std::optional<Fault> position_fault(const SwimmerState& swimmer) const;

  /// Moves swimmers whose bead 2 has left the block from `owned` to their new owners. Returns the beads near
  /// this block, sorted by name.
  std::vector<BeadOnLattice> publish(std::vector<SwimmerState>& owned);

  /// Returns the messages that have been sent so far.
  const Traffic& traffic() const { return traffic_; }

  /// Returns the ranks that this rank communicates with, including itself.
  const std::vector<int>& peers() const { return peers_; }

  /// Sends the impulses of `beads` to their owners. Returns the total impulses on the beads of owned
  /// swimmers.
  std::map<BeadName, Impulse> collect(std::span<const BeadOnLattice> beads);

 private:
  using Buffers = std::vector<std::vector<char>>;  ///< one per peer

  std::vector<char> announcement(const std::vector<SwimmerState>& owned, int peer) const;
  Buffers exchange(const Buffers& to_peers, int tag);

  MPI_Comm comm_;
  int rank_;
  Decomposition decomposition_;
  std::vector<BlockInLattice> blocks_;  ///< blocks of all ranks
  std::vector<int> peers_;
  Traffic traffic_;
  const std::vector<SwimmerType>& types_;
  std::vector<std::array<double, 3>> radii_;  ///< of each type, as the fluid sees the beads [cell]
};

}  // namespace beadswim
