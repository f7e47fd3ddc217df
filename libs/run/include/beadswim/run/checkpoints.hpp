#pragma once

#include <functional>
#include <memory>
#include <string>

#include "beadswim/core/communicator.hpp"
#include "beadswim/io/checkpoint_file.hpp"
#include "beadswim/run/run_settings.hpp"

// Checkpoints from which a run can continue. They are written alternately to the files FILE.h5md.ckpt.0 and
// FILE.h5md.ckpt.1. While one file is being written, the other file is therefore a complete checkpoint. Page:
// docs/formats/checkpoint.md.

namespace beadswim {

/// Opens and checks the checkpoint from which a run continues. `restart`: a checkpoint or a trajectory. A
/// trajectory can have two checkpoints; the latest complete one is opened, and `message` takes the faults of
/// the other, on rank 0. Throws InputError on all ranks if there is no complete checkpoint. Collective.
std::unique_ptr<CheckpointReader> open_checkpoint(const std::string& restart,
                                                  const std::function<void(const std::string&)>& message,
                                                  const Communicator& communicator);

/// Opens the checkpoint of an interrupted run with the same trajectory, layout, settings and version of the
/// program. `layout`: JSON text of the layout. Returns nullptr if there is none, or if the model is still to
/// be chosen. Collective.
std::unique_ptr<CheckpointReader> open_interrupted_run(const std::string& trajectory,
                                                       const std::string& layout, const RunSettings& settings,
                                                       const Communicator& communicator);

/// Returns the path of the trajectory to which `restart`, a checkpoint or a trajectory, belongs.
std::string trajectory_of(const std::string& restart);

/// Returns the settings of the run that wrote the checkpoint. Throws InputError if they cannot be read.
RunSettings settings_of(const CheckpointReader& checkpoint);

/// Throws InputError if a setting that affects the motion of the beads has different values in `wanted` and
/// in `present`, the settings of the run that wrote the checkpoint.
void require_same_results(const RunSettings& wanted, const RunSettings& present);

/// Returns the layout of the run that wrote the checkpoint, as JSON text.
std::string layout_of(const CheckpointReader& checkpoint);

/// Returns the number of time steps that the run had completed when it wrote the checkpoint.
long steps_done_in(const CheckpointReader& checkpoint);

}  // namespace beadswim
