#include "beadswim/run/run.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>

#include "beadswim/core/version.hpp"
#include "beadswim/io/h5md.hpp"
#include "beadswim/run/checkpoints.hpp"
#include "beadswim/scene/check.hpp"
#include "models/models.hpp"
#include "run_parts.hpp"

namespace beadswim {
namespace {

/// Adds a warning if swimmers complete no cycle until the last frame of the run.
void warn_of_missing_cycles(ModelPlan& plan) {
  const auto cycle = static_cast<double>(plan.steps_per_cycle);
  const double frame = cycle / std::min<double>(plan.settings.frames_per_cycle, cycle);
  double missing = 0, needed = 0, roundoff = 1e-9;
  for (const PlacedSwimmer& swimmer : plan.swimmers) {
    const double end = frame * std::ceil(std::round(plan.periods[swimmer.type]) / frame - roundoff);
    missing += end > static_cast<double>(plan.steps_in(plan.settings.cycles)) + 0.5;
    needed = std::max(needed, end);
  }
  if (missing > 0)
    add_warning(plan.warnings, "no-cycle",
                "the run is too short for a complete cycle of {} of {} swimmers, so it gives neither "
                "velocity nor stroke of them; run {:.6g} cycles or more",
                missing, plan.swimmers.size(), needed / cycle);
}

/// Returns the edge of a cell of the lattice, or the smallest radius of a bead [length].
double usual_flow_spacing(const ModelPlan& plan) {
  if (plan.lattice()) return plan.units.length;
  double smallest = INFINITY;
  for (const std::vector<double>& of_type : plan.radii)
    smallest = std::min(smallest, *std::ranges::min_element(of_type));
  return smallest;
}

/// Returns the absolute path, which different names of a file share.
std::filesystem::path absolute_path(const std::string& path) {
  std::error_code fault;
  const auto absolute = std::filesystem::weakly_canonical(std::filesystem::absolute(path, fault), fault);
  return fault ? std::filesystem::path(path) : absolute;
}

/// Returns true if the run writes to the trajectory of the earlier run that it continues.
bool continues_same_trajectory(const RunTask& task) {
  return task.checkpoint &&
         absolute_path(trajectory_of(task.checkpoint->path())) == absolute_path(task.trajectory);
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

/// Continues from the checkpoint of the task, if there is one, runs the time loop, and makes the record.
RunResult run_and_record(const RunParts& parts, RunTask& task) {
  std::optional<RunHistory> history;
  if (task.checkpoint) history = restore(parts, *task.checkpoint);
  task.checkpoint.reset();  // closes the file: a replaced open file would still use disk space
  const RunOutcome outcome = run_to_end(parts, history);
  RunResult result;
  result.late_warnings = parts.model.warnings();
  std::ranges::move(parts.recorder.warnings(), std::back_inserter(result.late_warnings));
  result.record = make_record(parts, task.document, outcome, result.late_warnings);
  result.steps_done = outcome.history.steps_done;
  if (parts.trajectory == nullptr) return result;
  parts.trajectory->finish();
  if (parts.communicator.is_root()) write_paraview_index(task.trajectory, parts.sinks);
  return result;
}

}  // namespace

std::optional<EarlyStop> stop_by_signal(int signal) {
  if (signal == 0) return std::nullopt;
  return EarlyStop{.reason = fmt::format("the run was stopped by signal {}", signal)};
}

std::unique_ptr<ModelPlan> plan_for(const RunTask& task, const Communicator& communicator) {
  require_ranges(task.settings);
  require_flow_syntax(task.settings);
  const auto make_plan = task.settings.model == RunModel::lbm ? lattice_plan : overdamped_plan;
  std::unique_ptr<ModelPlan> plan = make_plan(task.document.layout, task.settings, task.source, communicator);
  if (const int frames = plan->settings.frames_per_cycle; frames > plan->steps_per_cycle)
    add_warning(plan->warnings, "few-steps",
                "a cycle has only {} time steps, so {} frames per cycle are recorded instead of {}",
                plan->steps_per_cycle, plan->steps_per_cycle, frames);
  if (const std::string warning = warning_of_fixed_forces(task.document.layout); !warning.empty())
    plan->warnings.push_back({"forces-fixed-in-box", warning});
  if (!task.trajectory.empty() && !paraview_can_open(task.trajectory))
    add_warning(plan->warnings, "paraview-name",
                "ParaView cannot open the name {}: it needs ASCII characters without colon, backslash and ~, "
                "and no space at the start; give another name with {}",
                task.trajectory, Setting::output);
  plan->flow = flow_request(plan->settings, task.document.layout, usual_flow_spacing(*plan));
  warn_of_missing_cycles(*plan);
  if (task.checkpoint) plan->steps_done = steps_done_in(*task.checkpoint);
  if (task.checkpoint && plan->flow) require_flow_sums(*plan, *task.checkpoint);
  const double cycles = plan->settings.cycles;
  require_end_after(cycles, plan->steps_in(cycles), plan->steps_done, plan->steps_per_cycle);
  return plan;
}

TrajectoryHeader header_of(const LayoutDocument& document, const ModelPlan& plan) {
  TrajectoryHeader header;
  header.box = document.layout.domain.box;
  std::map<int, const SwimmerType*> types;  // by the id of the swimmer
  for (const Swimmer& swimmer : document.layout.swimmers)
    types[swimmer.id] = &document.layout.types.at(swimmer.type);
  for (const PlacedSwimmer& swimmer : plan.swimmers) {
    const int first = static_cast<int>(header.bead.size());
    for (const Bond& bond : types.at(swimmer.id)->bonds)
      header.bonds.push_back({first + bond.beads[0], first + bond.beads[1]});
    for (std::size_t b = 0; b < plan.radii[swimmer.type].size(); ++b) {
      header.swimmer.push_back(swimmer.id);
      header.bead.push_back(static_cast<int>(b) + 1);
      header.radius.push_back(plan.radii[swimmer.type][b]);
    }
  }
  // Units that readers of molecular simulations know. They refuse files with other units, but not files
  // without units.
  if (const Units& units = document.layout.units;
      !units.lattice && units.length.name == "nm" && units.time.name == "ns") {
    header.length_unit = units.length.name;
    header.time_unit = units.time.name;
  }
  header.creator_version = version() + " (" + revision() + ")";
  header.has_forces = plan.settings.frames_with == FrameContent::forces;
  header.layout = dump_json(layout_to_json(document));
  header.cycle_columns = columns_of<CycleStatistics>({}, widest_cycle(document.layout));
  return header;
}

RunResult run(RunTask& task, const ModelPlan& plan, const RunSinks& sinks, const Communicator& communicator) {
  const std::unique_ptr<Model> model = plan.make();
  std::optional<FlowOutput> flow;
  if (plan.flow && !task.trajectory.empty())
    flow.emplace(*plan.flow, plan, task.document.layout, task.trajectory,
                 continues_same_trajectory(task) ? plan.steps_done : 0, communicator);
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
                       .flow = flow ? &*flow : nullptr,
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
