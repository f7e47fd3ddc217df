#include "one_run.hpp"

#include <fmt/core.h>

#include "beadswim/core/rank_failure.hpp"
#include "beadswim/run/checkpoints.hpp"
#include "beadswim/tools/stop_signal.hpp"

namespace beadswim {
namespace {

void warn(const std::vector<RunWarning>& warnings) {
  for (const RunWarning& warning : warnings) print_message("warning: " + warning.message);
}

/// Prints a description of the run, and the warnings that are known before the run.
void announce(const ModelPlan& plan, const RunTask& task, const RunOptions& options) {
  if (options.progress != ProgressStyle::none) {
    print_message(plan.announcement);
    if (task.checkpoint)
      print_message(fmt::format("continuing from the checkpoint {}, step {}", task.checkpoint->path(),
                                plan.steps_done));
  }
  warn(plan.warnings);
}

/// Prints how the run can be continued from its last checkpoint.
void print_restart_flag(const std::string& checkpoint, const std::string& trajectory) {
  if (checkpoint.empty()) return;
  print_message(
      fmt::format("the state is saved; continue with --restart {}",
                  trajectory_of(checkpoint) == trajectory ? checkpoint : checkpoint + " -o " + trajectory));
}

/// Gives the task the settings of the cheapest run within the tolerance. Returns the plan. Collective.
RunPlan choose_settings(RunTask& task, const RunOptions& options, const Communicator& communicator) {
  RunPlan plan =
      plan_run(task.document.layout, plan_request(options, communicator), task.source, communicator);
  const PlannedRun& planned = choose_run(plan);
  task.settings = planned.settings;
  if (communicator.is_root() && options.progress != ProgressStyle::none)
    print_message(fmt::format(
        "starting the cheapest run within --tolerance: {}, with an error of up to {}, typically {}, and a "
        "cost of {:.3g} core-seconds",
        settings_text(planned.settings, options.chosen), in_percent(planned.errors.limits.total.largest()),
        in_percent(planned.errors.typical.largest()), planned.core_seconds));
  return plan;
}

}  // namespace

void print_message(const std::string& message) {
  print_to_stderr(fmt::format("{}: {}\n", program_name, message));
}

PlanRequest plan_request(const RunOptions& options, const Communicator& communicator) {
  return {.settings = options.settings,
          .chosen = options.chosen,
          .is_restart = !options.restart.empty(),
          .tolerance = options.tolerance,
          .has_advice = options.plan,
          .lattice_speed = [&communicator] { return speed_of_this_machine(print_message, communicator); }};
}

std::optional<EarlyStop> stop_request(const RunOptions& options, double start) {
  if (const auto stop = stop_by_signal(stop_signal())) return stop;
  if (!options.time_limit || MPI_Wtime() - start <= *options.time_limit) return std::nullopt;
  return EarlyStop{
      .status = RunStatus::stopped_time,
      .reason = fmt::format(
          "the time limit of {} s is reached; to complete the run, use a longer --time-limit or more ranks",
          *options.time_limit)};
}

std::unique_ptr<ModelPlan> plan_of(RunTask& task, const RunOptions& options,
                                   const Communicator& communicator) {
  constexpr double usual_accepted_error = 0.1;
  std::optional<RunPlan> choice;
  if (task.settings.model == RunModel::automatic) choice = choose_settings(task, options, communicator);
  require_settings_apply(options.chosen, task.settings.model);
  std::unique_ptr<ModelPlan> plan = plan_for(task, communicator);
  if (communicator.is_root())
    add_expected_errors(*plan, choice ? choice->tolerance : usual_accepted_error, [&] {
      return choice ? expected_errors(*choice, choose_run(*choice))
                    : expected_errors(task.document.layout, *plan);
    });
  return plan;
}

RunRecord run_alone(RunTask task, const RunOptions& options, double start, const Communicator& communicator,
                    const Communicator& failures) {
  const std::unique_ptr<ModelPlan> plan = plan_of(task, options, communicator);
  Progress progress(options.progress, *plan);
  if (communicator.is_root()) announce(*plan, task, options);
  catch_stop_signals();
  const RunSinks sinks{.message = print_message,
                       .progress = [&](long steps_done) { progress.update(steps_done); },
                       .stop = [&] { return stop_request(options, start); },
                       .failure =
                           [&](const std::string& checkpoint) {
                             print_restart_flag(checkpoint, task.trajectory);
                             abort_after_failure(program_name, failures);
                           }};
  RunResult result = run(task, *plan, sinks, communicator);
  if (communicator.is_root()) {
    progress.finish(result.steps_done);
    result.record.provenance->push_back(options.provenance);
    try {
      write_text("-", dump_json(run_record_to_json(result.record, options.record_provenance())));
    } catch (...) {
      print_restart_flag(result.last_checkpoint, task.trajectory);
      throw;
    }
    warn(result.late_warnings);
    const RunStatus status = result.record.status;
    if (status == RunStatus::stopped_time || status == RunStatus::stopped_signal)
      print_restart_flag(result.last_checkpoint, task.trajectory);
  }
  return result.record;
}

}  // namespace beadswim
