#pragma once

#include <memory>
#include <optional>
#include <string>

#include "beadswim/io/checkpoint_file.hpp"
#include "command_line/options.hpp"
#include "run_loop.hpp"

// Checkpoints of a run. They are written alternately to the files FILE.h5md.ckpt.0 and FILE.h5md.ckpt.1, so
// that one complete checkpoint remains while the next one is written. Page: docs/formats/checkpoint.md.

namespace beadswim {

/// Opens and checks the checkpoint that --restart names. `restart` is the argument of this flag: a checkpoint
/// or a trajectory. A trajectory has up to two checkpoints, of which the latest complete one is opened.
/// Throws InputError on all ranks if there is none. Collective.
std::unique_ptr<CheckpointReader> open_checkpoint(const std::string& restart,
                                                  const Communicator& communicator);

/// Returns the path of the trajectory to which `restart`, the argument of --restart, belongs.
std::string trajectory_of(const std::string& restart);

/// Returns the flags of the run that wrote the checkpoint. Throws InputError if they cannot be read.
FlagValues flags_of(const CheckpointReader& checkpoint);

/// Throws InputError if a flag that determines the physics of the run has different values in `options` and
/// in `flags`. `options`: command line. `flags`: flags of the run that wrote the checkpoint.
void require_same_result_flags(const RunOptions& options, const FlagValues& flags);

/// Returns the layout of the run that wrote the checkpoint, as JSON text.
std::string layout_of(const CheckpointReader& checkpoint);

/// Returns the number of steps that the run had completed when the checkpoint was written.
long steps_done_in(const CheckpointReader& checkpoint);

/// Restores model and recorder from a checkpoint and returns the history of the run that wrote it. Throws
/// SolverError if the checkpoint belongs to another run or to another version of the program. Collective.
RunHistory restore(Model& model, Recorder& recorder, const CheckpointReader& checkpoint,
                   const Communicator& communicator);

/// Writes the checkpoints of a run.
class Checkpoints {
 public:
  /// `layout`: JSON text of the layout. `restarted`: path of the checkpoint from which the run continues;
  /// empty for a new run. The checkpoint FILE of another run with the same name is renamed to FILE.old.
  /// Throws SolverError if this fails. Collective.
  Checkpoints(const RunOptions& options, std::string layout, const std::string& restarted,
              const Communicator& communicator);

  /// Writes a checkpoint of the present state, which must be free of faults. Throws SolverError on failure.
  /// The failure may be known to one rank only, so the caller must abort all ranks. Collective.
  void write(const RunParts& parts, const RunHistory& history);

  /// Returns the path of the latest checkpoint; empty if there is none.
  const std::string& last() const { return last_; }

 private:
  int slot_of(const std::string& checkpoint) const;  ///< 0 or 1; -1 if not a checkpoint of this run

  std::string output_, flags_, layout_;
  const Communicator& communicator_;
  int slot_ = 0;  ///< number of the file of the next checkpoint: 0 or 1
  std::string last_;
};

}  // namespace beadswim
