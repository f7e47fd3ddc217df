#include "one_run.hpp"

#include <fmt/core.h>

#include <memory>

#include "beadswim/core/error.hpp"
#include "beadswim/core/rank_failure.hpp"
#include "beadswim/io/xdmf.hpp"
#include "beadswim/plan/percent.hpp"
#include "beadswim/plan/run_length.hpp"
#include "beadswim/tools/program.hpp"
#include "checkpoints.hpp"
#include "planning/plan_flags.hpp"
#include "planning/plan_report.hpp"
#include "record/record.hpp"
#include "run_setup.hpp"
#include "stop_signal.hpp"

namespace beadswim {
namespace {

void warn(const std::vector<RunWarning>& warnings) {
  for (const RunWarning& warning : warnings)
    print_to_stderr(fmt::format("{}: warning: {}\n", program_name, warning.message));
}

/// Prints a description of the run and, for a single layout, the warnings that are known before the run.
void announce(const ModelPlan& plan, const Request& request) {
  if (plan.options.progress != ProgressStyle::none) {
    print_to_stderr(fmt::format("{}: {}\n", program_name, plan.announcement));
    if (request.checkpoint) {
      print_to_stderr(fmt::format("{}: continuing from the checkpoint {}, step {}\n", program_name,
                                  request.checkpoint->path(), request.steps_done));
    }
  }
  if (request.name.empty()) warn(plan.warnings);
}

/// Prints how the run can be continued from its last checkpoint.
void print_restart_flag(const Checkpoints& checkpoints, const Request& request) {
  const std::string &last = checkpoints.last(), &output = request.options.output;
  if (last.empty()) return;
  if (!request.name.empty())
    return print_to_stderr(
        fmt::format("{}: the state is saved; repeat the command to continue\n", program_name));
  print_to_stderr(fmt::format("{}: the state is saved; continue with --restart {}\n", program_name,
                              trajectory_of(last) == output ? last : last + " -o " + output));
}

/// Writes an index file with which ParaView opens the trajectory (XDMF). All results have been written
/// before, so a failure is not fatal.
void write_paraview_index(const std::string& path) {
  if (!paraview_can_open(path)) return;  // a warning at the start says so
  try {
    write_xdmf(path);
  } catch (const std::exception& error) {
    print_to_stderr(
        fmt::format("{}: warning: the index file for ParaView (.xdmf2) cannot be written: {}; the trajectory "
                    "itself is complete\n",
                    program_name, error.what()));
  }
}

/// Runs the time loop and passes the run record to `take` on rank 0. If one rank throws an exception, this
/// function aborts all ranks.
RunOutcome run_and_record(const RunParts& parts, Request& request, const LayoutDocument& document,
                          const TakeRecord& take, const Communicator& failures) {
  try {
    std::optional<RunHistory> history;
    if (request.checkpoint)
      history = restore(parts.model, parts.recorder, *request.checkpoint, parts.communicator);
    request.checkpoint.reset();  // closes the file: a replaced open file would still use disk space
    const RunOutcome outcome = run_to_end(parts, history);
    const RunRecord record = make_record(parts, document, outcome);
    parts.trajectory.finish();
    if (parts.communicator.is_root()) {
      take(record);
      write_paraview_index(parts.plan.options.output);
    }
    return outcome;
  } catch (...) {  // not rethrown: destructors would wait for the other ranks
    if (!request.checkpoint) print_restart_flag(parts.checkpoints, request);  // otherwise it is not readable
    abort_after_failure(program_name, failures);
  }
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
      "{}: starting the cheapest run within --tolerance: {}, with an error of up to {}, typically {}, and a "
      "cost of {:.3g} core-seconds\n",
      program_name, flags_of(planned, request.options), in_percent(planned.error.limit.largest()),
      in_percent(planned.error.typical.largest()), planned.core_seconds));
}

}  // namespace

RunOutcome run_layout(const LayoutDocument& document, Request& request, double start, const TakeRecord& take,
                      const Communicator& communicator, const Communicator& failures) {
  if (request.options.settings.model == RunModel::automatic) apply_plan(document, request, communicator);
  const std::unique_ptr<ModelPlan> planned = plan_for(document, request, communicator);
  const ModelPlan& plan = *planned;
  const RunOptions& options = plan.options;
  const long done = request.steps_done, steps = plan.steps_in(options.settings.cycles);
  require_end_after(options.settings.cycles, steps, done, plan.steps_per_cycle);
  Progress progress(options.progress, done, steps, static_cast<double>(plan.steps_per_cycle),
                    plan.updates_per_step, request.take_share);
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
  const RunOutcome outcome = run_and_record(parts, request, document, take, failures);
  const std::vector<RunWarning> warnings = warnings_after_run(parts);
  if (communicator.is_root() && request.name.empty()) {
    warn(warnings);
    if (outcome.status == RunStatus::stopped_time || outcome.status == RunStatus::stopped_signal)
      print_restart_flag(checkpoints, request);
  }
  return outcome;
}

}  // namespace beadswim
