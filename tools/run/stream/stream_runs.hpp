#pragma once

#include "beadswim/study/rank_groups.hpp"
#include "options.hpp"

// Runs of a stream of layouts. The ranks form groups; each group runs one layout after the other.

namespace beadswim {

/// Runs all layouts, or plans them with the flag --plan, and prints their records in order, one per line.
/// Each record is also written to the file NAME.json beside its trajectory NAME.h5md. A layout whose file
/// holds the record of the same run is not run again. `start`: MPI_Wtime from which --time-limit counts [s].
/// Throws InputError on all ranks, before work begins, if the command line does not fit a stream. Returns the
/// exit status. Collective.
int run_stream(const StoredStream& layouts, RunOptions options, double start,
               const Communicator& communicator, const Communicator& failures);

/// Implements the flag --plan for a stream: prints the plan of each layout as a line of JSON, and on standard
/// error a table of the cheapest runs within the tolerance with their sum. A layout that cannot be planned
/// has a failure in its place. Throws SolverError on all ranks, at the end, if a layout has no run within the
/// tolerance. Collective.
void plan_stream(const StoredStream& layouts, const RunOptions& options, StreamSchedule schedule,
                 const Communicator& communicator, const Communicator& failures);

}  // namespace beadswim
