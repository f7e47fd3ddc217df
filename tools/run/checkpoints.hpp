#pragma once

#include <memory>
#include <optional>
#include <string>

#include "beadswim/io/checkpoint_file.hpp"
#include "command_line/options.hpp"
#include "run_loop.hpp"

// Checkpoints of a run: FILE.h5md.ckpt.0 and .1 in turn, so that one whole checkpoint is there while the
// other is written. docs/formats/checkpoint.md.

namespace beadswim {

/// Finds and checks the file of --restart: one checkpoint, or a trajectory, of whose two checkpoints it takes
/// the last that is whole. Throws InputError alike on all ranks. Collective.
std::unique_ptr<CheckpointReader> open_checkpoint(const std::string& restart,
                                                  const Communicator& communicator);

/// The trajectory that a checkpoint, or what --restart names, belongs to.
std::string trajectory_of(const std::string& restart);

/// The flags of the checkpoint's run.
FlagValues flags_of(const CheckpointReader& checkpoint);

/// Throws InputError if the command line gives another value of what sets the course of the run than the
/// checkpoint's `flags`.
void require_same_course(const RunOptions& options, const FlagValues& flags);

/// The layout of the checkpoint's run, as text.
std::string layout_of(const CheckpointReader& checkpoint);

/// Steps done when it was taken.
long steps_in(const CheckpointReader& checkpoint);

/// Sets model and recorder to where the checkpoint's were. Collective.
RunPast restore(Model& model, Recorder& recorder, const CheckpointReader& checkpoint,
                const Communicator& communicator);

class Checkpoints {
 public:
  /// `layout`: text of the layout. `restarted`: the file that the run goes on from; empty if it began anew.
  /// Renames checkpoints of another run under this one's name, to ...old.
  Checkpoints(const RunOptions& options, std::string layout, const std::string& restarted,
              const Communicator& communicator);

  /// Keeps a sound run as it is now. Throws SolverError, maybe on one rank alone, which must then stop the
  /// others. Collective.
  void write(const RunParts& parts, const RunPast& past);

  /// The last one; empty before it.
  const std::string& last() const { return last_; }

 private:
  int slot_of(const std::string& checkpoint) const;  ///< -1: none of this run's

  std::string output_, flags_, layout_;
  const Communicator& communicator_;
  int slot_ = 0;  ///< of the next
  std::string last_;
};

}  // namespace beadswim
