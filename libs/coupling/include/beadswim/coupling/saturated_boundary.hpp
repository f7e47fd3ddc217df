#pragma once

#include <span>
#include <vector>

#include "beadswim/coupling/bead_on_lattice.hpp"
#include "beadswim/coupling/saturated_cells.hpp"
#include "beadswim/coupling/saturated_sums.hpp"
#include "beadswim/lattice/populations.hpp"

namespace beadswim {

/// The loop over partially saturated cells in one step of the fluid; the law of one is in saturated_cell.hpp.
/// Works on one rank's block.
struct SaturatedBoundary {
  const SaturatedCells& cells;
  std::span<const BeadOnLattice> beads;
  std::vector<SaturatedSums>& sums;  ///< one a bead
  double viscosity;                  ///< of the fluid [cell^2/step]

  /// Pushes what streams into the cells of row (y, z) of the block towards the motion of the beads that touch
  /// them, and adds up what the lattice gives up, and what it then holds within the beads. For step_fluid()
  /// to call before each row: nothing is read or written that another row's cells receive.
  void push_before_row(Populations& populations, int y, int z);
};

/// Adds the sums over a step to the beads' impulses, and starts them anew.
void hand_over_impulses(std::span<SaturatedSums> sums, std::span<BeadOnLattice> beads);

}  // namespace beadswim
