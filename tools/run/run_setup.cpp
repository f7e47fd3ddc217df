#include "run_setup.hpp"

#include <fmt/core.h>

#include "beadswim/core/version.hpp"
#include "models/lattice_model.hpp"
#include "models/overdamped_model.hpp"

namespace beadswim {
namespace {

std::unique_ptr<ModelPlan> plan_of_model(const LayoutDocument& document, const Request& request,
                                         const Communicator& communicator) {
  if (request.options.settings.model != RunModel::lbm)
    return std::make_unique<OverdampedPlan>(document.layout, request.options, request.source(), communicator);
  return std::make_unique<LatticePlan>(document.layout, request.options, request.source(), communicator);
}

}  // namespace

std::unique_ptr<ModelPlan> plan_for(const LayoutDocument& document, const Request& request,
                                    const Communicator& communicator) {
  std::unique_ptr<ModelPlan> plan = plan_of_model(document, request, communicator);
  if (const int frames = plan->options.settings.frames_per_cycle; frames > plan->steps_per_cycle)
    plan->warnings.push_back(
        fmt::format("a cycle has only {} time steps, so {} frames per cycle are recorded instead of {}",
                    plan->steps_per_cycle, plan->steps_per_cycle, frames));
  return plan;
}

TrajectoryHeader header_of(const LayoutDocument& document, const ModelPlan& plan) {
  TrajectoryHeader header;
  header.box = document.layout.domain;
  for (const PlacedSwimmer& swimmer : plan.swimmers) {
    for (int b = 0; b < 3; ++b) {
      header.swimmer.push_back(swimmer.id);
      header.bead.push_back(b + 1);
      header.radius.push_back(plan.radii[swimmer.type][b]);
    }
  }
  header.creator_version = version() + " (" + revision() + ")";
  header.parameters["layout"] = dump_json(layout_to_json(document));
  header.cycle_columns = columns_of<CycleStatistics>({});
  return header;
}

}  // namespace beadswim
