#include <fmt/core.h>

#include <cstdio>
#include <memory>

#include "beadswim/core/communicator.hpp"
#include "beadswim/core/error.hpp"
#include "beadswim/core/rank_failure.hpp"
#include "beadswim/io/xdmf.hpp"
#include "beadswim/plan/run_length.hpp"
#include "beadswim/tools/program.hpp"
#include "checkpoints.hpp"
#include "command_line/request.hpp"
#include "planning/plan_flags.hpp"
#include "planning/plan_report.hpp"
#include "record/record.hpp"
#include "run_loop.hpp"
#include "run_setup.hpp"
#include "stop_signal.hpp"

namespace {

using namespace beadswim;

constexpr const char* program_name = "beadswim-run";

/// Exception for a run that ended with a fault. All ranks throw it. The results up to the fault are complete.
class RunFailed : public SolverError {
 public:
  using SolverError::SolverError;
};

void require_steps_left(const ModelPlan& plan, long done) {
  const double cycles = plan.options.settings.cycles;
  if (done == 0 || done < total_steps(cycles, plan.steps_per_cycle)) return;
  throw InputError(
      "--cycles",
      fmt::format("{} is too small, because the checkpoint is already at cycle {:.6g}; give more cycles",
                  cycles, static_cast<double>(done) / static_cast<double>(plan.steps_per_cycle)));
}

void warn(const std::vector<std::string>& warnings) {
  for (const std::string& warning : warnings)
    print_to_stderr(fmt::format("{}: warning: {}\n", program_name, warning));
}

/// Prints the description of the run and its warnings.
void announce(const ModelPlan& plan, const Request& request) {
  if (plan.options.progress != ProgressStyle::none) {
    print_to_stderr(fmt::format("{}: {}\n", program_name, plan.announcement));
    if (request.checkpoint) {
      print_to_stderr(fmt::format("{}: continuing from {}, step {}\n", program_name,
                                  request.checkpoint->path(), request.steps_done));
    }
  }
  warn(plan.warnings);
}

void print_restart_flag(const Checkpoints& checkpoints) {
  if (checkpoints.last().empty()) return;
  print_to_stderr(
      fmt::format("{}: the state is saved; continue with --restart {}\n", program_name, checkpoints.last()));
}

void print_record(const RunRecord& record, const RunOptions& options) {
  const auto provenance = options.with_provenance ? RecordProvenance::written : RecordProvenance::left_out;
  write_text("-", dump_json(run_record_to_json(record, provenance)));
}

/// Writes the XDMF index for ParaView. The results are complete without it, so a failure is not fatal.
void write_paraview_index(const std::string& path) {
  try {
    write_xdmf(path);
  } catch (const std::exception& error) {
    print_to_stderr(
        fmt::format("{}: warning: the index for ParaView is missing: {}\n", program_name, error.what()));
  }
}

/// Runs the time loop and prints the run record. Aborts all ranks if an exception is thrown.
RunOutcome run_and_record(const RunParts& parts, Request& request, const LayoutDocument& document,
                          const Communicator& failures) {
  try {
    std::optional<RunHistory> history;
    if (request.checkpoint)
      history = restore(parts.model, parts.recorder, *request.checkpoint, parts.communicator);
    request.checkpoint.reset();  // closes the file, so that replacing it frees its disk space
    const RunOutcome outcome = run_to_end(parts, history);
    const RunRecord record = make_record(parts, document, outcome);
    parts.trajectory.finish();
    if (parts.communicator.is_root()) {
      print_record(record, parts.plan.options);
      write_paraview_index(parts.plan.options.output);
    }
    return outcome;
  } catch (...) {  // aborts here: closing the trajectory would wait for other ranks
    print_restart_flag(parts.checkpoints);
    abort_after_failure(program_name, failures);
  }
}

/// Implements --plan: prints the plan. Throws InputError if the expected error of no run is within the
/// tolerance. Collective.
int report_plan(const LayoutDocument& document, const Request& request, const Communicator& communicator) {
  const RunPlan plan =
      plan_run(document.layout, plan_request(request.options, communicator), request.source(), communicator);
  if (communicator.is_root()) {
    print_to_stderr(plan_table(plan, request.options, communicator));
    write_text("-", dump_json(plan_to_json(plan, request.options, communicator)));
  }
  choose_run(plan, request.options);
  return static_cast<int>(ExitStatus::fine);
}

/// Implements --model auto --tolerance E: uses the settings of the cheapest run whose expected error is
/// within the tolerance. Throws InputError if there is none. Collective.
void apply_plan(const LayoutDocument& document, Request& request, const Communicator& communicator) {
  const RunPlan plan =
      plan_run(document.layout, plan_request(request.options, communicator), request.source(), communicator);
  const PlannedRun& planned = choose_run(plan, request.options);
  request.options.settings = planned.settings;
  request.options.given.erase("--tolerance");  // it was the tolerance of the plan, not of the mobility
  if (!communicator.is_root() || request.options.progress == ProgressStyle::none) return;
  print_to_stderr(fmt::format(
      "{}: chosen run: {}, with an expected error of {:.2g} % and a cost of {:.3g} core-seconds\n",
      program_name, flags_of(planned, request.options), 100 * planned.error.largest(), planned.core_seconds));
}

/// Runs the program and returns its exit status. All ranks throw InputError if the input is invalid, before
/// the run begins.
int run(int argc, char** argv, const Communicator& communicator, const Communicator& failures) {
  const double start = MPI_Wtime();
  auto read = read_request(argc, argv, communicator);
  if (const int* status = std::get_if<int>(&read)) return *status;
  Request& request = std::get<Request>(read);
  const LayoutDocument document = read_layout(request, communicator);
  if (request.options.plan) return report_plan(document, request, communicator);
  if (request.options.settings.model == RunModel::automatic) apply_plan(document, request, communicator);
  const std::unique_ptr<ModelPlan> planned = plan_for(document, request, communicator);
  const ModelPlan& plan = *planned;
  const RunOptions& options = plan.options;
  const long done = request.steps_done;
  require_steps_left(plan, done);
  Progress progress(options.progress, done, total_steps(options.settings.cycles, plan.steps_per_cycle),
                    static_cast<double>(plan.steps_per_cycle), plan.cells);
  if (communicator.is_root()) announce(plan, request);

  const std::unique_ptr<Model> model = plan.make(request.continues_same_trajectory() ? done : 0);
  TrajectoryWriter trajectory(options.output, header_of(document, plan), communicator,
                              request.checkpoint.get());
  Recorder recorder(plan, document.layout, trajectory, communicator);
  Checkpoints checkpoints(options, dump_json(layout_to_json(document)),
                          request.checkpoint ? request.checkpoint->path() : "", communicator);
  const RunParts parts{.start = start,
                       .communicator = communicator,
                       .plan = plan,
                       .model = *model,
                       .trajectory = trajectory,
                       .recorder = recorder,
                       .checkpoints = checkpoints,
                       .progress = progress};
  catch_stop_signals();
  const RunOutcome outcome = run_and_record(parts, request, document, failures);
  const std::vector<std::string> warnings = model->warnings();
  if (communicator.is_root()) {
    warn(warnings);
    if (outcome.status == RunStatus::stopped_time || outcome.status == RunStatus::stopped_signal)
      print_restart_flag(checkpoints);
  }
  if (outcome.status == RunStatus::failed) throw RunFailed(outcome.reason);
  if (outcome.status != RunStatus::finished) throw StoppedEarly(outcome.reason);
  return static_cast<int>(ExitStatus::fine);
}

/// Returns the exit status for the current exception. All ranks throw the exceptions for invalid input,
/// faults and early stops, so only rank 0 reports them. Other exceptions end all ranks.
int report_failure(const Communicator& communicator, const Communicator& failures) {
  try {
    throw;
  } catch (const InputError&) {
    return communicator.is_root() ? report_current_exception(program_name)
                                  : static_cast<int>(ExitStatus::bad_input);
  } catch (const RunFailed&) {
    return communicator.is_root() ? report_current_exception(program_name)
                                  : static_cast<int>(ExitStatus::failed);
  } catch (const StoppedEarly&) {
    return communicator.is_root() ? report_current_exception(program_name)
                                  : static_cast<int>(ExitStatus::stopped_early);
  } catch (...) {
    return end_after_failure(program_name, failures);
  }
}

}  // namespace

int main(int argc, char** argv) {
  const MpiSession mpi(&argc, &argv);
  const Communicator communicator(MPI_COMM_WORLD), failures(MPI_COMM_WORLD);
  if (!communicator.is_root() && std::freopen("/dev/null", "w", stdout) == nullptr) return 3;
  try {
    return run(argc, argv, communicator, failures);
  } catch (...) {
    return report_failure(communicator, failures);
  }
}
