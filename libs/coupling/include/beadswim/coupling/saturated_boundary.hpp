#pragma once

#include <span>
#include <vector>

#include "beadswim/coupling/bead_on_lattice.hpp"
#include "beadswim/coupling/saturated_cells.hpp"
#include "beadswim/coupling/saturated_sums.hpp"
#include "beadswim/lattice/populations.hpp"

namespace beadswim {

/// Loop over the partially saturated cells of the block of one rank in one step of the fluid. The law of one
/// cell is in saturated_cell.hpp.
struct SaturatedBoundary {
  const SaturatedCells& cells;
  std::span<const BeadOnLattice> beads;
  std::vector<SaturatedSums>& sums;  ///< one per bead
  double viscosity;                  ///< kinematic, of the fluid [cell^2/step]

  /// Applies the forces of beads on the fluid in the cells of row (y, z) of the block, by changing the
  /// incoming populations of these cells. Adds to `sums` the impulses on the beads and the momentum that the
  /// fluid within the beads then has. step_fluid() must call it before each row. It uses no incoming
  /// populations of other rows.
  void apply_forces_before_row(Populations& populations, int y, int z);
};

/// Adds the sums over a step to the impulses of the beads and resets the sums.
void transfer_impulses(std::span<SaturatedSums> sums, std::span<BeadOnLattice> beads);

}  // namespace beadswim
