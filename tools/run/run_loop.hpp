#pragma once

#include <string>

#include "models/model.hpp"
#include "progress.hpp"
#include "record/recorder.hpp"

namespace beadswim {

class Checkpoints;

/// What a run has behind it when its loop begins: at its start nothing.
struct RunPast {
  long steps_done = 0;
  double wall_seconds = 0, core_seconds = 0;
};

struct RunOutcome {
  RunStatus status = RunStatus::finished;
  std::string reason;  ///< why it stopped before its end; empty if it did not
  double wall_seconds = 0, core_seconds = 0;
  ModelTotals last_totals;  ///< when all was well the last time
};

/// What a run's time loop drives.
struct RunParts {
  double start;  ///< of the program, by MPI_Wtime: what --time-limit counts from
  const Communicator& communicator;
  const ModelPlan& plan;
  Model& model;
  TrajectoryWriter& trajectory;
  Recorder& recorder;
  Checkpoints& checkpoints;
  Progress& progress;
};

/// Advances until the last step, a fault, the time limit or a signal; from the start, or from where `past`
/// ends. Takes no frame and no checkpoint once a fault is there. Collective.
RunOutcome run_to_end(const RunParts& parts, const std::optional<RunPast>& past);

}  // namespace beadswim
