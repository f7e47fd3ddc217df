#pragma once

#include "beadswim/coupling/coupled_system.hpp"
#include "beadswim/io/checkpoint_file.hpp"

// Sections of a checkpoint for a lattice run: populations, and swimmers with their pending impulses.

namespace beadswim {

/// Writes the state of the system to a checkpoint. Collective.
void write_lattice_state(CheckpointWriter& file, CoupledSystem& system, const Communicator& communicator);

/// Restores the system from a checkpoint. Throws SolverError if its swimmers are not those of the scene.
/// Collective.
void read_lattice_state(const CheckpointReader& file, CoupledSystem& system, const SystemProgress& progress,
                        const Communicator& communicator);

}  // namespace beadswim
