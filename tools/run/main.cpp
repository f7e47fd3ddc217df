#include <cstdio>
#include <cstdlib>
#include <variant>

#include "beadswim/core/communicator.hpp"
#include "beadswim/core/error.hpp"
#include "beadswim/core/rank_failure.hpp"
#include "beadswim/run/checkpoints.hpp"
#include "one_run.hpp"
#include "request.hpp"
#include "stream/stream_runs.hpp"

namespace {

using namespace beadswim;

/// Implements the flag --plan: prints expected errors and costs of all possible runs. Throws InputError if no
/// run has an expected error within the tolerance. Collective.
int report_plan(const LayoutDocument& document, const Request& request, const Communicator& communicator) {
  PlanRequest wanted = plan_request(request.options, communicator);
  if (request.checkpoint) wanted.steps_done = steps_done_in(*request.checkpoint);
  const RunPlan plan = plan_run(document.layout, wanted, request.source(), communicator);
  if (communicator.is_root()) {
    const std::string& layout = request.options.layouts.front();
    print_to_stderr(plan_table(plan, layout));
    Json json = plan_to_json(plan, layout);
    if (request.options.with_provenance) json["provenance"] = Json::array({request.options.provenance});
    write_text("-", dump_json(json));
  }
  choose_run(plan);
  return static_cast<int>(ExitStatus::fine);
}

/// Executes the program and returns its exit status. Invalid input makes all ranks throw InputError before
/// the run begins.
int run_program(int argc, char** argv, const Communicator& communicator, const Communicator& failures) {
  const double start = MPI_Wtime();
  auto read = read_request(argc, argv, communicator);
  if (const int* status = std::get_if<int>(&read)) return *status;
  Request& request = std::get<Request>(read);
  const GivenLayouts given = read_layouts(request, communicator);
  if (given.is_stream) return run_stream(given.layouts, request.options, start, communicator, failures);
  const LayoutDocument document = read_layout(request, given.layouts);
  if (request.options.plan) return report_plan(document, request, communicator);
  RunTask task{.document = document,
               .settings = request.options.settings,
               .source = request.source(),
               .trajectory = request.options.output,
               .checkpoint = std::move(request.checkpoint)};
  const RunRecord record = run_alone(std::move(task), request.options, start, communicator, failures);
  if (record.status == RunStatus::failed) throw RunFailed(record.reason);
  if (record.status != RunStatus::finished) throw StoppedEarly(record.reason);
  return static_cast<int>(ExitStatus::fine);
}

/// Reports the exception that is being handled and returns the exit status. InputError, RunFailed and
/// StoppedEarly are thrown by all ranks together, so rank 0 alone prints the message, and every rank ends
/// normally. Any other exception may be thrown by one rank only; this rank then prints the message and aborts
/// the other ranks.
int report_failure(const Communicator& communicator, const Communicator& failures) {
  const auto report_on_root = [&](ExitStatus status) {
    return communicator.is_root() ? report_current_exception(program_name) : static_cast<int>(status);
  };
  try {
    throw;
  } catch (const InputError&) {
    return report_on_root(ExitStatus::bad_input);
  } catch (const RunFailed&) {
    return report_on_root(ExitStatus::failed);
  } catch (const StoppedEarly&) {
    if (communicator.is_root() && std::getenv("OMPI_COMM_WORLD_SIZE") != nullptr)
      print_to_stderr(
          "beadswim-run: the run ends with exit status 4, which mpirun reports as a failure; mpirun --quiet "
          "omits this report\n");
    return report_on_root(ExitStatus::stopped_early);
  } catch (...) {
    return end_after_failure(program_name, failures);
  }
}

}  // namespace

int main(int argc, char** argv) {
  setenv("HDF5_USE_FILE_LOCKING", "FALSE", 1);  // the program locks its files itself
  const MpiSession mpi(&argc, &argv);
  const Communicator communicator(MPI_COMM_WORLD), failures(MPI_COMM_WORLD);
  if (!communicator.is_root() && std::freopen("/dev/null", "w", stdout) == nullptr) return 3;
  try {
    return run_program(argc, argv, communicator, failures);
  } catch (...) {
    return report_failure(communicator, failures);
  }
}
