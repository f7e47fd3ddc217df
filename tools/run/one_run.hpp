#pragma once

#include <memory>
#include <string>

#include "beadswim/core/error.hpp"
#include "beadswim/plan/run_plan.hpp"
#include "beadswim/run/run.hpp"
#include "options.hpp"

namespace beadswim {

/// Exception for a run that ended with a fault (an unphysical state), thrown on all ranks. The results until
/// the fault have been written.
class RunFailed : public SolverError {
 public:
  using SolverError::SolverError;
};

/// Prints a message with the name of the program on standard error.
void print_message(const std::string& message);

/// Returns the request for a plan in which every run has the settings that the command line fixes. The
/// request refers to `communicator`, which must exist as long as the request.
PlanRequest plan_request(const RunOptions& options, const Communicator& communicator);

/// Returns the request to stop of the program, after a signal to this rank or the time limit. `start`:
/// MPI_Wtime from which the time limit counts [s].
std::optional<EarlyStop> stop_request(const RunOptions& options, double start);

/// Returns the description of the run of a task, with its expected errors. If the model is auto, plans all
/// possible runs before and gives the task the settings of the cheapest run whose expected error is at most
/// that of --tolerance. Throws InputError on all ranks if the model cannot treat the layout. Collective.
std::unique_ptr<ModelPlan> plan_of(RunTask& task, const RunOptions& options,
                                   const Communicator& communicator);

/// Runs one layout: prints warnings, progress, and how to continue after an early stop. Returns the record
/// with the provenance of this program. `start`: MPI_Wtime from which --time-limit counts [s]. Throws
/// InputError on all ranks of the communicator, before the run begins. If a rank fails later, all ranks of
/// the program are aborted. `failures`: communicator of all ranks of the program, for nothing else.
/// Collective.
RunRecord run_alone(RunTask task, const RunOptions& options, double start, const Communicator& communicator,
                    const Communicator& failures);

}  // namespace beadswim
