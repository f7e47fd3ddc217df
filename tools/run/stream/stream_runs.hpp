#pragma once

#include "beadswim/study/stream.hpp"
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

}  // namespace beadswim
