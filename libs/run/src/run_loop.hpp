#pragma once

#include <string>

#include "beadswim/run/run.hpp"
#include "record/recorder.hpp"

namespace beadswim {

class Checkpoints;

/// Number of steps and cost of the earlier runs that this run continues; zero for a new run.
struct RunHistory {
  long steps_done = 0;
  double wall_seconds = 0, core_seconds = 0;
};

/// Result of the time loop.
struct RunOutcome {
  RunStatus status = RunStatus::finished;
  std::string reason;  ///< why the run stopped early; empty if it finished
  double wall_seconds = 0, core_seconds = 0;
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
  Checkpoints& checkpoints;
};

/// Advances the model until the last step, a fault or a request to stop. `history`: steps and cost of the run
/// that this run continues; nullopt for a new run. After a fault, no frame and no checkpoint is written.
/// Collective.
RunOutcome run_to_end(const RunParts& parts, const std::optional<RunHistory>& history);

}  // namespace beadswim
