#pragma once

#include <map>
#include <optional>
#include <span>
#include <vector>

#include "beadswim/core/communicator.hpp"
#include "beadswim/core/message.hpp"
#include "beadswim/coupling/bead_images.hpp"
#include "beadswim/coupling/bead_on_lattice.hpp"
#include "beadswim/coupling/fault.hpp"
#include "beadswim/coupling/scene.hpp"
#include "beadswim/coupling/swimmer_state.hpp"
#include "beadswim/lattice/levels.hpp"

namespace beadswim {

/// Smallest permitted gap between the surface of a bead and a wall [cell]. With a smaller gap, the bead can
/// cover the cells next to the wall.
constexpr double min_wall_gap = 0.5;

/// Smallest permitted gap between the surface of a bead and the end of the finest level [cell]. With a
/// smaller gap, a link could read populations beyond the end.
constexpr double min_level_gap = 3;

/// Exchanges messages about beads between the MPI rank that owns a swimmer and the ranks whose lattice cells
/// its beads touch.
class BeadExchange {
 public:
  BeadExchange(const Communicator& communicator, const Decomposition& decomposition,
               const CoupledScene& scene);

  /// Returns the rank that owns a swimmer whose middle() is at `position` (unwrapped coordinates [cell]): the
  /// rank whose block contains this point.
  int owner_of(const Vec3& position) const;

  /// Returns a fault if the beads of a swimmer must not be published at their present positions. Fault::step
  /// is not set.
  /// - torn_arm: an arm is longer than max_stretch, so that its beads may touch blocks of ranks that are not
  ///   peers.
  /// - wall: the gap between a bead and a wall is smaller than min_wall_gap.
  /// - level: the gap between a bead and a coarser level is smaller than min_level_gap.
  std::optional<Fault> position_fault(const SwimmerState& swimmer) const;

  /// Sends the beads of the swimmers in `owned` to the ranks near the beads. Moves each swimmer whose
  /// middle() has left the block to the list `owned` of its new owner. Returns the beads of all swimmers that
  /// are near this block, sorted by swimmer and bead.
  std::vector<BeadOnLattice> publish(std::vector<SwimmerState>& owned);

  const Traffic& traffic() const { return traffic_; }

  /// Returns the ranks that this rank communicates with, including itself.
  const std::vector<int>& peers() const { return peers_; }

  /// Sends the impulses that the cells of this rank have transferred to `beads` to the owners of the beads.
  /// Returns, for each bead of the swimmers that this rank owns, the sum of the impulses from all ranks.
  std::map<BeadName, Impulse> collect(std::span<const BeadOnLattice> beads);

 private:
  /// Sends one message to each peer, and returns those that the peers have sent.
  std::vector<IncomingMessage> exchange(const std::vector<OutgoingMessage>& to_peers, int tag);

  MPI_Comm comm_;
  int rank_;
  Decomposition decomposition_;
  LevelPlace place_;                    ///< place of the finest level
  std::vector<BlockInLattice> blocks_;  ///< blocks of all ranks
  std::vector<int> peers_;
  Traffic traffic_;
  const std::vector<SwimmerType>& types_;
  /// Radii with which the beads of each type act on the fluid [cell] (CoupledScene::radius_on_lattice()).
  std::vector<std::vector<double>> radii_;
};

}  // namespace beadswim
