#include "beadswim/core/rank_failure.hpp"

#include <chrono>
#include <cstdlib>
#include <thread>

#include "beadswim/core/error.hpp"

namespace beadswim {
namespace {

constexpr double max_wait = 2;  // longest time between the failures of two ranks that fail together [s]

/// Returns true if all ranks call this function within `max_wait` seconds, otherwise false.
bool all_ranks_fail_together(const Communicator& communicator) {
  MPI_Request barrier = MPI_REQUEST_NULL;
  MPI_Ibarrier(communicator.get(), &barrier);
  const double start = MPI_Wtime();
  for (int is_complete = 0; MPI_Wtime() - start < max_wait;) {
    MPI_Test(&barrier, &is_complete, MPI_STATUS_IGNORE);
    if (is_complete) return true;
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  return false;
}

/// Ends all ranks of the program. The mpirun of Open MPI (which sets OMPI_COMMAND) ends the other ranks as
/// soon as one process exits. MPI_Abort would print a banner after the message of the failed rank. Other
/// launchers need MPI_Abort.
[[noreturn]] void abort_ranks(const Communicator& communicator, int status) {
  if (std::getenv("OMPI_COMMAND")) std::_Exit(status);
  MPI_Abort(communicator.get(), status);
  std::abort();
}

}  // namespace

void run_on_root(const std::function<void()>& action, const Communicator& communicator) {
  std::string input_fault, failure;
  if (communicator.is_root()) {
    try {
      action();
    } catch (const InputError& error) {
      input_fault = error.what();
    } catch (const SolverError& error) {
      failure = error.what();
    }
  }
  broadcast(input_fault, communicator);
  broadcast(failure, communicator);
  if (!input_fault.empty()) throw InputError(input_fault);
  if (!failure.empty()) throw SolverError(failure);
}

int end_after_failure(const std::string& program, const Communicator& failures) {
  constexpr int failed = static_cast<int>(ExitStatus::failed);
  if (all_ranks_fail_together(failures))
    return failures.is_root() ? report_current_exception(program) : failed;
  report_current_exception(program);
  abort_ranks(failures, failed);
}

void abort_after_failure(const std::string& program, const Communicator& failures) {
  constexpr int failed = static_cast<int>(ExitStatus::failed);
  // If rank 0 fails too, it reports its error and ends all ranks while this rank waits.
  if (!failures.is_root()) std::this_thread::sleep_for(std::chrono::duration<double>(max_wait));
  report_current_exception(program);
  if (failures.size() == 1) std::_Exit(failed);
  abort_ranks(failures, failed);
}

}  // namespace beadswim
