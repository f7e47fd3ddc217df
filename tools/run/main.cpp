#include <fmt/core.h>

#include <cstdio>
#include <memory>

#include "beadswim/core/communicator.hpp"
#include "beadswim/core/error.hpp"
#include "beadswim/core/rank_failure.hpp"
#include "beadswim/io/xdmf.hpp"
#include "beadswim/plan/percent.hpp"
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

/// Exception for a run that ended with a fault (an unphysical state), thrown on all ranks. The results until
/// the fault have been written.
class RunFailed : public SolverError {
 public:
  using SolverError::SolverError;
};

void require_steps_left(const ModelPlan& plan, long done) {
  const double cycles = plan.options.settings.cycles;
  if (done == 0 || done < plan.steps_in(cycles)) return;
  throw InputError(
      "--cycles", fmt::format("the number of cycles, {}, is too small, because the checkpoint is already at "
                              "cycle {:.6g}; give more cycles",
                              cycles, static_cast<double>(done) / static_cast<double>(plan.steps_per_cycle)));
}

void warn(const std::vector<RunWarning>& warnings) {
  for (const RunWarning& warning : warnings)
    print_to_stderr(fmt::format("{}: warning: {}\n", program_name, warning.message));
}

/// Prints a description of the run and the warnings that are known before the run.
void announce(const ModelPlan& plan, const Request& request) {
  if (plan.options.progress != ProgressStyle::none) {
    print_to_stderr(fmt::format("{}: {}\n", program_name, plan.announcement));
    if (request.checkpoint) {
      print_to_stderr(fmt::format("{}: continuing from the checkpoint {}, step {}\n", program_name,
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

/// Writes an index file with which ParaView opens the trajectory (XDMF). All results have been written
/// before, so a failure is not fatal.
void write_paraview_index(const std::string& path) {
  try {
    write_xdmf(path);
  } catch (const std::exception& error) {
    print_to_stderr(
        fmt::format("{}: warning: the index file for ParaView (.xdmf2) cannot be written: {}; the trajectory "
                    "itself is complete\n",
                    program_name, error.what()));
  }
}

/// Runs the time loop and prints the run record. If one rank throws an exception, this function aborts all
/// ranks.
RunOutcome run_and_record(const RunParts& parts, Request& request, const LayoutDocument& document,
                          const Communicator& failures) {
  try {
    std::optional<RunHistory> history;
    if (request.checkpoint)
      history = restore(parts.model, parts.recorder, *request.checkpoint, parts.communicator);
    request.checkpoint.reset();  // closes the file: a replaced open file would still use disk space
    const RunOutcome outcome = run_to_end(parts, history);
    const RunRecord record = make_record(parts, document, outcome);
    parts.trajectory.finish();
    if (parts.communicator.is_root()) {
      print_record(record, parts.plan.options);
      write_paraview_index(parts.plan.options.output);
    }
    return outcome;
  } catch (...) {  // not rethrown: destructors would wait for the other ranks
    print_restart_flag(parts.checkpoints);
    abort_after_failure(program_name, failures);
  }
}

/// Implements the flag --plan: prints expected errors and costs of all possible runs. Throws InputError if no
/// run has an expected error within the tolerance. Collective.
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

/// Implements --model auto with --tolerance E: plans all possible runs and adopts the settings of the
/// cheapest run whose expected error is at most E. Throws InputError if there is no such run. Collective.
void apply_plan(const LayoutDocument& document, Request& request, const Communicator& communicator) {
  const RunPlan plan =
      plan_run(document.layout, plan_request(request.options, communicator), request.source(), communicator);
  const PlannedRun& planned = choose_run(plan, request.options);
  request.options.settings = planned.settings;
  request.options.tolerance.reset();  // the tolerance of the plan; the run does not use it
  request.options.accepted_error = plan.tolerance;
  if (!communicator.is_root() || request.options.progress == ProgressStyle::none) return;
  print_to_stderr(fmt::format(
      "{}: starting the cheapest run within --tolerance: {}, with an expected error of {} and a cost of "
      "{:.3g} core-seconds\n",
      program_name, flags_of(planned, request.options), in_percent(planned.error.largest()),
      planned.core_seconds));
}

/// Executes the program and returns its exit status. Invalid input makes all ranks throw InputError before
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
  Progress progress(options.progress, done, plan.steps_in(options.settings.cycles),
                    static_cast<double>(plan.steps_per_cycle), plan.updates_per_step);
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
  const std::vector<RunWarning> warnings = model->warnings();
  if (communicator.is_root()) {
    warn(warnings);
    if (outcome.status == RunStatus::stopped_time || outcome.status == RunStatus::stopped_signal)
      print_restart_flag(checkpoints);
  }
  if (outcome.status == RunStatus::failed) throw RunFailed(outcome.reason);
  if (outcome.status != RunStatus::finished) throw StoppedEarly(outcome.reason);
  return static_cast<int>(ExitStatus::fine);
}

/// Reports the exception that is being handled and returns the exit status. InputError, RunFailed and
/// StoppedEarly are thrown by all ranks together, so rank 0 alone prints the message, and every rank ends
/// normally. Any other exception may be thrown by one rank only; this rank then prints the message and aborts
/// the other ranks.
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
