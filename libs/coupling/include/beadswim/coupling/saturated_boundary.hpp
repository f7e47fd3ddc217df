#pragma once

#include <span>
#include <vector>

#include "beadswim/coupling/bead_on_lattice.hpp"
#include "beadswim/coupling/saturated_cells.hpp"
#include "beadswim/coupling/saturated_sums.hpp"
#include "beadswim/lattice/populations.hpp"

namespace beadswim {

/// Force of beads on the fluid in a saturated cell in one step, in lattice units.
struct SaturatedForce {
  std::ptrdiff_t cell;    ///< index in the populations
  double fluid_fraction;  ///< fraction of the cell that no bead fills
  Vec3 force;             ///< momentum that the fluid gained
};

/// Loop over the saturated cells of the block of one rank, for one time step of the fluid. A cell is
/// saturated if a bead covers it partly or completely. The equations for one cell are in saturated_cell.hpp.
struct SaturatedBoundary {
  const SaturatedCells& cells;
  std::span<const BeadOnLattice> beads;
  std::vector<SaturatedSums>& sums;     ///< one per bead
  std::vector<SaturatedForce>& forces;  ///< one per cell
  /// Momentum that each cell gains at the end of the step. Half of it belongs to the momentum v that the
  /// force drives to the velocity of the bead, so the force acts as if the bead were slower by this half.
  Vec3 body_force;
  double viscosity;  ///< kinematic viscosity of the fluid [cell^2/step]

  /// Applies the forces of beads on the fluid in the cells of row (y, z) of the block, by changing the
  /// incoming populations of these cells. Adds to `forces` these forces, and to `sums` the impulses on the
  /// beads, and the momentum of the fluid within the beads after the change. step_fluid() must call this
  /// function before each row. The function uses incoming populations of this row only.
  void apply_forces_before_row(Populations& populations, int y, int z);
};

/// Adds the impulse and angular impulse on each bead in one step, and the momentum and angular momentum of
/// the fluid within it (`sums`, one entry per bead), to BeadOnLattice::impulse. Resets `sums` to zero.
void transfer_impulses(std::span<SaturatedSums> sums, std::span<BeadOnLattice> beads);

}  // namespace beadswim
