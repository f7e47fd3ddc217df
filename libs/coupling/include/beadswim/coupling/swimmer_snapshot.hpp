#pragma once

#include <vector>

#include "beadswim/coupling/bead_on_lattice.hpp"
#include "beadswim/coupling/swimmer_state.hpp"

namespace beadswim {

/// Complete state of a swimmer between two steps.
struct SwimmerSnapshot {
  SwimmerState state;
  std::vector<Impulse> pending_impulses;  ///< impulses on its beads, not yet applied; sums over all ranks

  static void visit_fields(auto&& visit, auto& snapshot) {
    visit("state", snapshot.state);
    visit("pending_impulses", snapshot.pending_impulses);
  }
};

/// Returns the snapshots as bytes, snapshot_size(beads) bytes per swimmer. Only machines with the same byte
/// order and sizes of numbers can read these bytes.
std::vector<char> bytes_of(const std::vector<SwimmerSnapshot>& snapshots);

/// Inverse of bytes_of(). Throws SolverError if the bytes are not valid.
std::vector<SwimmerSnapshot> snapshots_from_bytes(std::vector<char> bytes);

/// Returns the size of the snapshot of a swimmer with this number of beads [byte].
std::size_t snapshot_size(std::size_t beads);

}  // namespace beadswim
