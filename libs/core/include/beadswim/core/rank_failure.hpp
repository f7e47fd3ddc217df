#pragma once

#include <functional>
#include <string>

#include "beadswim/core/communicator.hpp"

namespace beadswim {

/// Calls `action` on rank 0. If it throws InputError or SolverError, all ranks throw it. Collective.
void run_on_root(const std::function<void()>& action, const Communicator& communicator);

/// Prints the message of the current exception and ends the program on all ranks. Must be called inside a
/// catch block. If all ranks call this function within a few seconds, only rank 0 prints its message, and the
/// function returns, on each rank, the exit status that main should return. Otherwise this rank prints its
/// message and calls MPI_Abort, so that Open MPI also prints a message. `failures` is a communicator that is
/// used for nothing else.
int end_after_failure(const std::string& program, const Communicator& failures);

/// Prints the message of the current exception and ends the processes of all ranks without MPI_Finalize. Use
/// this function for a failure while files are open that only all ranks together can close. Each rank except
/// rank 0 first waits a few seconds; if rank 0 fails in this time, only rank 0 prints its message. If there
/// are several ranks, Open MPI also prints a message.
[[noreturn]] void abort_after_failure(const std::string& program, const Communicator& failures);

}  // namespace beadswim
