#pragma once

#include "beadswim/coupling/coupled_system.hpp"
#include "beadswim/io/checkpoint_file.hpp"

// What a checkpoint keeps of a lattice run: populations, and swimmers with the impulses under way to them.

namespace beadswim {

/// Collective.
void write_lattice_state(CheckpointWriter& file, CoupledSystem& system, const Communicator& communicator);

/// Sets the system to where the checkpoint's was. Collective.
void read_lattice_state(const CheckpointReader& file, CoupledSystem& system, const SystemMoment& moment,
                        const Communicator& communicator);

}  // namespace beadswim
