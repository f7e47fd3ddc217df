#pragma once

#include <array>
#include <vector>

#include "beadswim/coupling/bead_on_lattice.hpp"
#include "beadswim/coupling/swimmer_state.hpp"

namespace beadswim {

/// A swimmer between two steps, whole.
struct SwimmerSnapshot {
  SwimmerState state;
  std::array<Impulse, 3> under_way;  ///< handed over to its beads by all ranks, not collected yet

  static void visit_fields(auto&& visit, auto& snapshot) {
    visit("state", snapshot.state);
    visit("under_way", snapshot.under_way);
  }
};

/// As many bytes for each swimmer, the same on machines of one kind.
std::vector<char> bytes_of(const std::vector<SwimmerSnapshot>& snapshots);

/// Throws SolverError if these are no such bytes.
std::vector<SwimmerSnapshot> snapshots_from_bytes(std::vector<char> bytes);

/// Bytes of one snapshot.
std::size_t snapshot_size();

}  // namespace beadswim
