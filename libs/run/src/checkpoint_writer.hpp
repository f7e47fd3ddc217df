#pragma once

#include <string>

#include "beadswim/run/run.hpp"
#include "run_loop.hpp"

namespace beadswim {

/// Restores the model and the recorder from a checkpoint, and returns steps and cost of the run that wrote
/// it. `message` takes a warning if another version of the program wrote the checkpoint. Throws SolverError
/// if the checkpoint belongs to another scene or has another format. Collective.
RunHistory restore(const RunParts& parts, const CheckpointReader& checkpoint);

/// Writes the checkpoints of a run.
class Checkpoints {
 public:
  /// `layout`: JSON text of the layout. If checkpoints of another run have the names that this run will use,
  /// they are renamed to NAME.old. Without a trajectory no checkpoint is written. Throws SolverError if
  /// renaming fails. Collective.
  Checkpoints(const RunTask& task, const ModelPlan& plan, const Communicator& communicator);

  /// Writes a checkpoint of the present state, which must be free of faults. Throws SolverError if writing
  /// fails. Possibly only one rank throws, so the caller must then abort all ranks. Collective.
  void write(const RunParts& parts, const RunHistory& history);
  /// Returns the path of the latest checkpoint; empty if there is none.
  const std::string& last() const { return last_; }

 private:
  int slot_of(const std::string& checkpoint) const;  ///< 0 or 1: file of this run; -1: another file

  std::string trajectory_, settings_, layout_;
  const Communicator& communicator_;
  int slot_ = 0;  ///< number of the file of the next checkpoint: 0 or 1
  std::string last_;
};

}  // namespace beadswim
