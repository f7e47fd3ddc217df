#pragma once

#include <string>

#include "beadswim/coupling/coupled_system.hpp"
#include "flow_output.hpp"
#include "progress.hpp"
#include "recorder.hpp"

namespace beadswim {

class Checkpoints;

/// What a run has behind it when its loop begins: at its start nothing.
struct RunPast {
  SystemMoment moment;
  SceneTotals first_totals;  ///< at its start
  double wall_seconds = 0, core_seconds = 0;
};

struct RunOutcome {
  RunStatus status = RunStatus::finished;
  std::string reason;  ///< why it stopped before its end; empty if it did not
  double wall_seconds = 0, core_seconds = 0;
  long own_steps = 0;                     ///< done by this program, not by one that it goes on from
  SceneTotals first_totals, last_totals;  ///< at the start, and when all was well the last time
};

/// What a run's time loop drives.
struct RunParts {
  double start;  ///< of the program, by MPI_Wtime: what --time-limit counts from
  const Communicator& communicator;
  CoupledSystem& system;
  TrajectoryWriter& trajectory;
  Recorder& recorder;
  Checkpoints& checkpoints;
  FlowOutput* flow;  ///< none: nullptr
  Progress& progress;
};

/// Advances until the last step, a fault, the time limit or a signal; from the start, or from where `past`
/// ends. Takes no frame and no checkpoint once a fault is there. Collective.
RunOutcome run_to_end(const RunParts& parts, const SceneOnLattice& on_lattice, const RunOptions& options,
                      const std::optional<RunPast>& past);

/// Steps of the whole run.
long total_steps(const SceneOnLattice& on_lattice, const RunOptions& options);

/// Steps between flow fields, or checkpoints, each so many cycles.
long steps_between(const SceneOnLattice& on_lattice, double cycles);

}  // namespace beadswim
