#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "beadswim/core/communicator.hpp"
#include "beadswim/documents/layout_document.hpp"
#include "beadswim/documents/run_record_document.hpp"
#include "beadswim/io/checkpoint_file.hpp"
#include "beadswim/run/model.hpp"
#include "beadswim/run/run_settings.hpp"

// A run of a layout: one way in, one way out.
//
//   RunTask task{.document = layout, .settings = settings, .source = "layout.json",
//                .trajectory = "run.h5md"};
//   const std::unique_ptr<ModelPlan> plan = plan_for(task, communicator);
//   const RunResult result = run(task, *plan, {}, communicator);
//
// The library handles no signal, prints nothing and ends no process. What a program wants to know or to
// decide during a run passes through RunSinks.

namespace beadswim {

/// What is to be run, and where results go.
struct RunTask {
  LayoutDocument document;
  RunSettings settings;      ///< the model must not be automatic
  std::string source;        ///< name of the layout in messages
  std::string trajectory{};  ///< path; empty: no trajectory, checkpoint or flow field is written
  /// Checkpoint from which the run continues; nullptr: the run begins at time 0.
  std::unique_ptr<CheckpointReader> checkpoint{};
};

/// Returns the request to stop after a signal to this process; nullopt if `signal` is 0.
std::optional<EarlyStop> stop_by_signal(int signal);

/// Functions that a run calls, each of which may be empty.
struct RunSinks {
  /// Takes a notice or a warning: a sentence without full stop. Rank 0 only.
  std::function<void(const std::string&)> message{};
  /// Takes the number of time steps that are done, every 20 steps. Rank 0 only.
  std::function<void(long)> progress{};
  /// Returns a request to stop, on any rank; nullopt: the run goes on. Called every 20 steps.
  std::function<std::optional<EarlyStop>()> stop{};
  /// Called inside the catch block of an exception that one rank may have thrown alone, with the path of the
  /// latest checkpoint (empty: none). Files are open then that only all ranks together can close, so a
  /// program with several ranks must end all of them here. On one rank this function may return; run() then
  /// throws the exception.
  std::function<void(const std::string&)> failure{};
};

/// Result of a run.
struct RunResult {
  RunRecord record;                       ///< status and reason on all ranks, all else on rank 0 only
  std::vector<RunWarning> late_warnings;  ///< warnings that were not known before the run; rank 0 only
  std::string last_checkpoint;            ///< path; empty if there is none
  long steps_done = 0;
};

/// Returns the description of a run with the model of the task. Throws InputError on all ranks if the model
/// cannot treat the layout, or if the run ends before its checkpoint. Collective.
std::unique_ptr<ModelPlan> plan_for(const RunTask& task, const Communicator& communicator);

/// Runs the plan of the task: moves the swimmers until the last step, a fault or a request to stop, and
/// writes trajectory, checkpoints and flow fields. After a fault, no frame and no checkpoint is written.
/// Closes the checkpoint of the task. Throws InputError on all ranks if a file cannot be created, SolverError
/// if a file cannot be written or the checkpoint is damaged. Collective.
RunResult run(RunTask& task, const ModelPlan& plan, const RunSinks& sinks, const Communicator& communicator);

}  // namespace beadswim
