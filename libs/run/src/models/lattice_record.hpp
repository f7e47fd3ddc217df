#pragma once

#include "beadswim/coupling/coupled_system.hpp"
#include "beadswim/coupling/scene_on_lattice.hpp"
#include "beadswim/documents/run_record_document.hpp"

namespace beadswim {

/// Adds the data of a lattice run to a record that already contains status and cost: model, resolution,
/// dimensionless numbers, near contact, cell updates, communication, and the hash of the state. `own_steps`:
/// number of time steps of this run alone, without an earlier run that it continues; `traffic`: messages of
/// this rank in these steps. The record is complete on rank 0 only. Collective.
void describe_lattice_run(RunRecord& record, const CoupledSystem& system, const SceneOnLattice& on_lattice,
                          const Traffic& traffic, long own_steps, const Communicator& communicator);

}  // namespace beadswim
