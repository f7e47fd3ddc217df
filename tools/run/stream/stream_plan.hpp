#pragma once

#include "beadswim/study/rank_groups.hpp"
#include "options.hpp"

namespace beadswim {

/// Implements the flag --plan for a stream: prints the plan of each layout as a line of JSON, and on standard
/// error a table of the cheapest runs within the tolerance with their sum. A layout that cannot be planned
/// has a failure in its place. Throws SolverError on all ranks, at the end, if a layout has no run within the
/// tolerance. Collective.
void plan_stream(const StoredStream& layouts, const RunOptions& options, StreamSchedule schedule,
                 const Communicator& communicator, const Communicator& failures);

}  // namespace beadswim
