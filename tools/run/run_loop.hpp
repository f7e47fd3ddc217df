#pragma once

#include <string>

#include "beadswim/coupling/coupled_system.hpp"
#include "flow_output.hpp"
#include "progress.hpp"
#include "recorder.hpp"

namespace beadswim {

struct RunOutcome {
  RunStatus status = RunStatus::finished;
  std::string reason;  ///< why it stopped before its end; empty if it did not
  double wall_seconds = 0;
  SceneTotals first_totals, last_totals;  ///< at the start, and when all was well the last time
};

/// What a run's time loop drives.
struct RunParts {
  const Communicator& communicator;
  CoupledSystem& system;
  Recorder& recorder;
  FlowOutput* flow;  ///< none: nullptr
  Progress& progress;
};

/// Advances until the last step, a fault, the time limit or a signal. Takes no frame once a fault is there.
/// Collective.
RunOutcome run_to_end(const RunParts& parts, const SceneOnLattice& on_lattice, const RunOptions& options);

/// Steps of the whole run.
long total_steps(const SceneOnLattice& on_lattice, const RunOptions& options);

}  // namespace beadswim
