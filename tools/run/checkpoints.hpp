#pragma once

#include <memory>
#include <optional>
#include <string>

#include "beadswim/io/checkpoint_file.hpp"
#include "command_line/options.hpp"
#include "run_loop.hpp"

// Checkpoints of a run. The files FILE.h5md.ckpt.0 and .1 are written alternately, so that one complete
// checkpoint exists while the other is written. Page: docs/formats/checkpoint.md.

namespace beadswim {

/// Opens and checks the checkpoint that --restart names. For a trajectory, opens the latest complete one of
/// its two checkpoints. Throws InputError on all ranks if there is none. Collective.
std::unique_ptr<CheckpointReader> open_checkpoint(const std::string& restart,
                                                  const Communicator& communicator);

/// Returns the trajectory of the run that the argument of --restart names: a trajectory or a checkpoint.
std::string trajectory_of(const std::string& restart);

/// Returns the flags of the checkpoint's run. Throws InputError if they cannot be read.
FlagValues flags_of(const CheckpointReader& checkpoint);

/// Throws InputError if a flag that determines the physics of the run differs between the command line and
/// `flags`, the flags of the checkpoint.
void require_same_course(const RunOptions& options, const FlagValues& flags);

/// Returns the layout of the checkpoint's run as JSON text.
std::string layout_of(const CheckpointReader& checkpoint);

/// Returns the number of steps that the run had completed when the checkpoint was written.
long steps_done_in(const CheckpointReader& checkpoint);

/// Restores model and recorder from a checkpoint and returns the history of its run. Throws SolverError if
/// the checkpoint does not belong to this run or version. Collective.
RunHistory restore(Model& model, Recorder& recorder, const CheckpointReader& checkpoint,
                   const Communicator& communicator);

/// Writes the checkpoints of a run.
class Checkpoints {
 public:
  /// `layout`: JSON text of the layout. `restarted`: the checkpoint that the run continues; empty for a new
  /// run. Checkpoints of another run with the same file names are renamed: `.old` is appended. Throws
  /// SolverError if this fails. Collective.
  Checkpoints(const RunOptions& options, std::string layout, const std::string& restarted,
              const Communicator& communicator);

  /// Writes a checkpoint of the present state, which must be free of faults. Throws SolverError, possibly on
  /// a single rank only, which must then stop the others. Collective.
  void write(const RunParts& parts, const RunHistory& history);

  /// Returns the path of the latest checkpoint; empty if there is none.
  const std::string& last() const { return last_; }

 private:
  int slot_of(const std::string& checkpoint) const;  ///< 0 or 1; -1 if it is no checkpoint of this run

  std::string output_, flags_, layout_;
  const Communicator& communicator_;
  int slot_ = 0;  ///< slot of the next checkpoint
  std::string last_;
};

}  // namespace beadswim
