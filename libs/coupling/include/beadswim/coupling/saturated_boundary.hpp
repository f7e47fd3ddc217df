#pragma once

#include <span>

#include "beadswim/coupling/bead_on_lattice.hpp"
#include "beadswim/coupling/saturated_cells.hpp"
#include "beadswim/lattice/populations.hpp"

namespace beadswim {

/// The loop over partially saturated cells in one step of the fluid; the law of one is in saturated_cell.hpp.
/// Works on one rank's block.
struct SaturatedBoundary {
  const SaturatedCells& cells;
  std::span<BeadOnLattice> beads;
  double viscosity;  ///< of the fluid [cell^2/step]

  /// Pushes what streams into the cells of row (y, z) of the block towards the motion of the beads that touch
  /// them, and adds what the lattice gives up, and what it holds within the beads, to the beads' impulses.
  /// For step_fluid() to call before each row: nothing is read or written that another row's cells receive.
  void push_before_row(Populations& populations, int y, int z);
};

}  // namespace beadswim
