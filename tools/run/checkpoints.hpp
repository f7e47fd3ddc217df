#pragma once

#include <memory>
#include <optional>
#include <string>

#include "beadswim/io/checkpoint_file.hpp"
#include "command_line/options.hpp"
#include "run_loop.hpp"

// Checkpoints of a run. They are written alternately to the files FILE.h5md.ckpt.0 and FILE.h5md.ckpt.1.
// While one file is being written, the other file is therefore a complete checkpoint. Page:
// docs/formats/checkpoint.md.

namespace beadswim {

/// Opens and checks the checkpoint from which a run continues. `restart`: value of the flag --restart, a
/// checkpoint or a trajectory. A trajectory can have two checkpoints; the latest complete one is opened.
/// Throws InputError on all ranks if there is no complete checkpoint. Collective.
std::unique_ptr<CheckpointReader> open_checkpoint(const std::string& restart,
                                                  const Communicator& communicator);

/// Opens the checkpoint of an interrupted run with the same trajectory, layout, flags and version of the
/// program. `layout`: JSON text of the layout. Returns nullptr if there is none, or if the model is still to
/// be chosen. Collective.
std::unique_ptr<CheckpointReader> open_interrupted_run(const RunOptions& options, const std::string& layout,
                                                       const Communicator& communicator);

/// Returns the path of the trajectory to which `restart`, the value of the flag --restart, belongs.
std::string trajectory_of(const std::string& restart);

/// Returns the flags of the run that wrote the checkpoint. Throws InputError if they cannot be read.
FlagValues flags_of(const CheckpointReader& checkpoint);

/// Throws InputError if a flag that affects the motion of the beads has different values in `options` (the
/// command line) and in `flags` (the run that wrote the checkpoint).
void require_same_result_flags(const RunOptions& options, const FlagValues& flags);

/// Returns the layout of the run that wrote the checkpoint, as JSON text.
std::string layout_of(const CheckpointReader& checkpoint);

/// Returns the number of time steps that the run had completed when it wrote the checkpoint.
long steps_done_in(const CheckpointReader& checkpoint);

/// Restores the model and the recorder from a checkpoint, and returns steps and cost of the run that wrote
/// it. Prints a warning if another version of the program wrote the checkpoint. Throws SolverError if the
/// checkpoint belongs to another scene or has another format. Collective.
RunHistory restore(Model& model, Recorder& recorder, const CheckpointReader& checkpoint,
                   const Communicator& communicator);

/// Writes the checkpoints of a run.
class Checkpoints {
 public:
  /// `layout`: JSON text of the layout. `restarted`: path of the checkpoint from which the run continues;
  /// empty for a new run. If checkpoints of another run have the names that this run will use, they are
  /// renamed to NAME.old. Throws SolverError if renaming fails. Collective.
  Checkpoints(const RunOptions& options, std::string layout, const std::string& restarted,
              const Communicator& communicator);

  /// Writes a checkpoint of the present state, which must be free of faults. Throws SolverError if writing
  /// fails. Possibly only one rank throws, so the caller must then abort all ranks. Collective.
  void write(const RunParts& parts, const RunHistory& history);

  /// Returns the path of the latest checkpoint; empty if there is none.
  const std::string& last() const { return last_; }

 private:
  int slot_of(const std::string& checkpoint) const;  ///< 0 or 1: file of this run; -1: another file

  std::string output_, flags_, layout_;
  const Communicator& communicator_;
  int slot_ = 0;  ///< number of the file of the next checkpoint: 0 or 1
  std::string last_;
};

}  // namespace beadswim
