#pragma once

#include "beadswim/coupling/coupled_system.hpp"
#include "beadswim/io/checkpoint_file.hpp"

// Sections of a checkpoint that describe the state of a lattice run: the populations of the fluid, and the
// swimmers with their pending impulses. A pending impulse is momentum that the fluid has already lost to a
// bead, but the bead has not yet received.

namespace beadswim {

/// Writes the state of the system to a checkpoint. Collective.
void write_lattice_state(CheckpointWriter& file, CoupledSystem& system);

/// Restores the system from a checkpoint of the same levels. Throws SolverError if the checkpoint contains
/// swimmers of another scene. Collective.
void read_lattice_state(const CheckpointReader& file, CoupledSystem& system, const SystemProgress& progress);

}  // namespace beadswim
