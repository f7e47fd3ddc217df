#pragma once

#include <span>
#include <string>

#include "beadswim/run/run.hpp"
#include "flow/flow_output.hpp"
#include "record/recorder.hpp"

// The parts of run(): time loop, checkpoints, record and header of the trajectory. They share RunParts.

namespace beadswim {

class Checkpoints;

/// Number of steps and cost of a run, including the earlier runs that it continues; zero for a new run.
struct RunHistory {
  long steps_done = 0;
  double wall_seconds = 0, core_seconds = 0;
};

/// Result of the time loop.
struct RunOutcome {
  RunStatus status = RunStatus::finished;
  std::string reason;  ///< why the run stopped early; empty if it finished
  RunHistory history;
  ModelTotals last_totals;  ///< totals at the last check that found no fault
};

/// Objects that the time loop of a run uses.
struct RunParts {
  const Communicator& communicator;
  const ModelPlan& plan;
  const RunSinks& sinks;
  Model& model;
  TrajectoryWriter* trajectory;  ///< nullptr: none is written
  Recorder& recorder;
  FlowOutput* flow;  ///< nullptr: none is written
  Checkpoints& checkpoints;
};

/// Returns the constant data of the trajectory file: box, beads, layout and program version.
TrajectoryHeader header_of(const LayoutDocument& document, const ModelPlan& plan);

/// Advances the model until the last step, a fault or a request to stop. `history`: steps and cost of the run
/// that this run continues; nullopt for a new run. After a fault, no frame and no checkpoint is written.
/// Collective.
RunOutcome run_to_end(const RunParts& parts, const std::optional<RunHistory>& history);

/// Writes the checkpoints of a run.
class Checkpoints {
 public:
  /// If checkpoints of another run have the names that this run will use, they are renamed to NAME.old.
  /// Without a trajectory no checkpoint is written. Throws SolverError if renaming fails. Collective.
  Checkpoints(const RunTask& task, const ModelPlan& plan, const Communicator& communicator);

  /// Writes a checkpoint of the present state, which must be free of faults. Throws SolverError if writing
  /// fails. Possibly only one rank throws, so the caller must then abort all ranks. Collective.
  void write(const RunParts& parts, const RunHistory& history);
  /// Returns the path of the latest checkpoint; empty if there is none.
  const std::string& last() const { return last_; }

 private:
  std::string trajectory_, settings_, layout_;
  const Communicator& communicator_;
  int slot_ = 0;  ///< number of the file of the next checkpoint: 0 or 1
  std::string last_;
};

/// Restores the model and the recorder from a checkpoint, and returns steps and cost of the run that wrote
/// it. RunSinks::message takes a warning if another version of the program wrote the checkpoint. Throws
/// SolverError if the checkpoint belongs to another scene or has another format. Collective.
RunHistory restore(const RunParts& parts, const CheckpointReader& checkpoint);

/// Throws InputError if the flow that the run needs from before the checkpoint is not in it (require_sums()).
void require_flow_sums(const ModelPlan& plan, const CheckpointReader& checkpoint);

/// Throws SolverError because the checkpoint has contents of another version of the program.
[[noreturn]] void refuse_other_version(const CheckpointReader& checkpoint);

/// Returns the run record. `late`: warnings that are known after the run. The record is complete on rank 0
/// only. Collective.
RunRecord make_record(const RunParts& parts, const LayoutDocument& layout, const RunOutcome& outcome,
                      const std::vector<RunWarning>& late);

/// Returns the dimensionless numbers of a run, except the Mach number. `speed`: largest bead speed. `period`:
/// base period. All arguments must have the same system of units.
DimensionlessNumbers dimensionless_numbers(std::span<const SwimmerType> types, double speed,
                                           double kinematic_viscosity, double period);

}  // namespace beadswim
