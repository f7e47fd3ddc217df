#pragma once

#include <string>

#include "beadswim/core/communicator.hpp"

namespace beadswim {

/// Reports the exception in flight and ends the program on all ranks; call it inside a catch block. If all
/// ranks call it within a few seconds, rank 0 reports, and every rank returns an exit status with which main
/// can finish. Otherwise this rank reports and calls MPI_Abort, after which Open MPI prints a message of its
/// own. `failures`: a communicator that nothing else uses.
int end_after_failure(const std::string& program, const Communicator& failures);

/// Reports the exception in flight and ends the processes of all ranks without MPI_Finalize: for failures
/// while files are open, which all ranks would have to close together. If rank 0 fails within a few seconds,
/// it alone reports. With several ranks, Open MPI prints a message of its own.
[[noreturn]] void abort_after_failure(const std::string& program, const Communicator& failures);

}  // namespace beadswim
