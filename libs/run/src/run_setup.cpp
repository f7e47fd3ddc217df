#include "run_setup.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "beadswim/core/version.hpp"
#include "beadswim/io/xdmf.hpp"
#include "beadswim/run/checkpoints.hpp"
#include "beadswim/scene/check.hpp"
#include "models/lattice_model.hpp"
#include "models/overdamped_model.hpp"
#include "record/recorder.hpp"

namespace beadswim {
namespace {

std::unique_ptr<ModelPlan> plan_of_model(const RunTask& task, const Communicator& communicator) {
  const Layout& layout = task.document.layout;
  if (task.settings.model != RunModel::lbm)
    return std::make_unique<OverdampedPlan>(layout, task.settings, task.source, communicator);
  return std::make_unique<LatticePlan>(layout, task.settings, task.source, communicator);
}

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
    plan.warnings.push_back(
        {"no-cycle",
         fmt::format("the run is too short for a complete cycle of {} of {} swimmers, so it gives neither "
                     "velocity nor stroke of them; run {:.6g} cycles or more",
                     missing, plan.swimmers.size(), needed / cycle)});
}

}  // namespace

std::unique_ptr<ModelPlan> plan_for(const RunTask& task, const Communicator& communicator) {
  require_ranges(task.settings);
  std::unique_ptr<ModelPlan> plan = plan_of_model(task, communicator);
  if (const int frames = plan->settings.frames_per_cycle; frames > plan->steps_per_cycle)
    plan->warnings.push_back(
        {"few-steps",
         fmt::format("a cycle has only {} time steps, so {} frames per cycle are recorded instead of {}",
                     plan->steps_per_cycle, plan->steps_per_cycle, frames)});
  if (const std::string warning = warning_of_fixed_forces(task.document.layout); !warning.empty())
    plan->warnings.push_back({"forces-fixed-in-box", warning});
  if (!task.trajectory.empty() && !paraview_can_open(task.trajectory))
    plan->warnings.push_back(
        {"paraview-name",
         fmt::format("ParaView cannot open the name {}: it needs ASCII characters without colon, backslash "
                     "and ~, and no space at the start; give another name with {}",
                     task.trajectory, Setting::output)});
  warn_of_missing_cycles(*plan);
  if (task.checkpoint) plan->steps_done = steps_done_in(*task.checkpoint);
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
  header.layout = dump_json(layout_to_json(document));
  header.cycle_columns = columns_of<CycleStatistics>({}, widest_cycle(document.layout));
  return header;
}

}  // namespace beadswim
