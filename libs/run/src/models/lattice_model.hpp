#pragma once

#include <vector>

#include "beadswim/coupling/coupled_system.hpp"
#include "beadswim/coupling/scene_on_lattice.hpp"
#include "beadswim/documents/run_record_document.hpp"
#include "beadswim/io/checkpoint_file.hpp"
#include "models/fault_message.hpp"

// Parts of the model lbm: its messages, its data in a record, and its state in a checkpoint.

namespace beadswim {

/// Returns what the message of a fault says about the run. `mach_so_far`: largest Mach number of a bead
/// before the fault.
FaultyRun faulty_run(const Fault& fault, const SceneOnLattice& on_lattice, double mach_so_far);

/// Returns the warnings that are known before the run; they do not stop it. `roundoff`: relative error of the
/// swimmers' velocity caused by rounding of the populations, from velocity_roundoff().
std::vector<RunWarning> warnings_before(const SceneOnLattice& on_lattice, double roundoff);

/// Returns a warning if the beads were so fast that compressibility affects the results. `mach`: largest Mach
/// number of a bead in the run.
std::vector<RunWarning> warnings_after(double mach);

/// Adds the data of a lattice run to a record that already contains status and cost: model, resolution,
/// dimensionless numbers, near contact, cell updates, communication, and the hash of the state. `own_steps`:
/// number of time steps of this run alone, without an earlier run that it continues; `traffic`: messages of
/// this rank in these steps. The record is complete on rank 0 only. Collective.
void describe_lattice_run(RunRecord& record, const CoupledSystem& system, const SceneOnLattice& on_lattice,
                          const Traffic& traffic, long own_steps, const Communicator& communicator);

/// Writes the state of the system to a checkpoint: the populations of the fluid, and the swimmers with their
/// pending impulses. A pending impulse is momentum that the fluid has already lost to a bead, but the bead
/// has not yet received. Collective.
void write_lattice_state(CheckpointWriter& file, CoupledSystem& system);

/// Restores the system from a checkpoint of the same levels. Throws SolverError if the checkpoint contains
/// swimmers of another scene. Collective.
void read_lattice_state(const CheckpointReader& file, CoupledSystem& system, const SystemProgress& progress);

}  // namespace beadswim
