#pragma once

#include <functional>

#include "beadswim/core/error.hpp"
#include "beadswim/documents/layout_document.hpp"
#include "command_line/request.hpp"
#include "run_loop.hpp"

namespace beadswim {

constexpr const char* program_name = "beadswim-run";

/// Exception for a run that ended with a fault (an unphysical state), thrown on all ranks. The results until
/// the fault have been written.
class RunFailed : public SolverError {
 public:
  using SolverError::SolverError;
};

/// Takes the run record, on rank 0.
using TakeRecord = std::function<void(const RunRecord&)>;

/// Runs one layout: plans it if the model is auto, moves the swimmers, writes the trajectory, and passes the
/// record to `take`. `start`: MPI_Wtime from which --time-limit counts [s]. Throws InputError on all ranks of
/// the communicator, before the run begins, if the model cannot treat the layout. If a rank fails later, all
/// ranks of the program are aborted. `failures`: communicator of all ranks of the program, for nothing else.
/// Collective.
RunOutcome run_layout(const LayoutDocument& document, Request& request, double start, const TakeRecord& take,
                      const Communicator& communicator, const Communicator& failures);

}  // namespace beadswim
