#include "beadswim/run/run.hpp"

#include <fmt/core.h>

#include <filesystem>

#include "beadswim/io/xdmf.hpp"
#include "beadswim/run/checkpoints.hpp"
#include "checkpoint_writer.hpp"
#include "record/record.hpp"
#include "run_loop.hpp"
#include "run_setup.hpp"

namespace beadswim {
namespace {

/// Returns the absolute path, which different names of a file share.
std::filesystem::path absolute_path(const std::string& path) {
  std::error_code fault;
  const auto absolute = std::filesystem::weakly_canonical(std::filesystem::absolute(path, fault), fault);
  return fault ? std::filesystem::path(path) : absolute;
}

/// Writes an index file with which ParaView opens the trajectory (XDMF). All results have been written
/// before, so a failure is not fatal.
void write_paraview_index(const std::string& path, const RunSinks& sinks) {
  if (!paraview_can_open(path)) return;  // a warning of the plan says so
  try {
    write_xdmf(path);
  } catch (const std::exception& error) {
    if (sinks.message)
      sinks.message(
          fmt::format("warning: the index file for ParaView (.xdmf2) cannot be written: {}; the trajectory "
                      "itself is complete",
                      error.what()));
  }
}

std::vector<RunWarning> late_warnings(const RunParts& parts) {
  std::vector<RunWarning> warnings = parts.model.warnings();
  std::ranges::move(parts.recorder.warnings(), std::back_inserter(warnings));
  return warnings;
}

/// Continues from the checkpoint of the task, if there is one, runs the time loop, and makes the record.
RunResult run_and_record(const RunParts& parts, RunTask& task) {
  std::optional<RunHistory> history;
  if (task.checkpoint) history = restore(parts, *task.checkpoint);
  task.checkpoint.reset();  // closes the file: a replaced open file would still use disk space
  const RunOutcome outcome = run_to_end(parts, history);
  RunResult result;
  result.late_warnings = late_warnings(parts);
  result.record = make_record(parts, task.document, outcome, result.late_warnings);
  result.steps_done = parts.model.steps_done();
  if (parts.trajectory == nullptr) return result;
  parts.trajectory->finish();
  if (parts.communicator.is_root()) write_paraview_index(task.trajectory, parts.sinks);
  return result;
}

}  // namespace

bool RunTask::continues_same_trajectory() const {
  return checkpoint && absolute_path(trajectory_of(checkpoint->path())) == absolute_path(trajectory);
}

RunResult run(RunTask& task, const ModelPlan& plan, const RunSinks& sinks, const Communicator& communicator) {
  const std::unique_ptr<Model> model =
      plan.make(task.trajectory, task.continues_same_trajectory() ? plan.steps_done : 0);
  std::optional<TrajectoryWriter> trajectory;
  if (!task.trajectory.empty())
    trajectory.emplace(task.trajectory, header_of(task.document, plan), communicator, task.checkpoint.get());
  TrajectoryWriter* const writer = trajectory ? &*trajectory : nullptr;
  Recorder recorder(plan, task.document.layout, writer, communicator);
  Checkpoints checkpoints(task, plan, communicator);
  const RunParts parts{.communicator = communicator,
                       .plan = plan,
                       .sinks = sinks,
                       .model = *model,
                       .trajectory = writer,
                       .recorder = recorder,
                       .checkpoints = checkpoints};
  try {
    RunResult result = run_and_record(parts, task);
    result.last_checkpoint = checkpoints.last();
    return result;
  } catch (...) {
    const bool is_readable = !task.checkpoint;  // otherwise the state could not be restored
    if (sinks.failure) sinks.failure(is_readable ? checkpoints.last() : "");
    throw;
  }
}

}  // namespace beadswim
