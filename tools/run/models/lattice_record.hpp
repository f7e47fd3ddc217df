#pragma once

#include "beadswim/coupling/coupled_system.hpp"
#include "beadswim/coupling/scene_on_lattice.hpp"
#include "beadswim/documents/run_record_document.hpp"

namespace beadswim {

/// Adds to a record with status and cost what is a lattice run's own: model, resolution, dimensionless
/// numbers, near contact, cell updates, communication and the state's hash. `own_steps`: done by this
/// program, not by one that it goes on from. Whole on rank 0. Collective.
void describe_lattice_run(RunRecord& record, const CoupledSystem& system, const SceneOnLattice& on_lattice,
                          long own_steps, const Communicator& communicator);

}  // namespace beadswim
