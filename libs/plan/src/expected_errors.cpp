#include "beadswim/plan/run_plan.hpp"

#include <fmt/core.h>

#include "beadswim/core/reason_against.hpp"
#include "beadswim/run/run_length.hpp"
#include "beadswim/run/velocity_roundoff.hpp"
#include "planned_scene.hpp"

namespace beadswim {
namespace {

RunErrors run_errors(const SceneFacts& facts, const ModelPlan& plan) {
  if (const SceneOnLattice* on_lattice = plan.lattice()) {
    const long steps_per_cycle = on_lattice->lattice.steps_per_period;
    const long steps = total_steps(plan.settings.cycles, steps_per_cycle);
    return lattice_run_errors(*on_lattice, facts,
                              velocity_roundoff(on_lattice->scene, steps_per_cycle, steps));
  }
  return mobility_run_errors(facts, *mobility_model(plan.settings.model), plan.settings.mobility);
}

/// Throws InputError if errors have not been validated for this type of swimmers; empty: for all.
void require_validated(const std::string& type) {
  if (!type.empty())
    throw InputError(
        fmt::format("error estimates have been validated for the paper's three-bead swimmers only, "
                    "not for the type \"{}\"; compare runs with different resolutions",
                    type));
}

}  // namespace

ExpectedErrors expected_errors(const Layout& layout, const ModelPlan& plan) {
  const SceneFacts facts = scene_facts(layout, plan.settings.cycles);
  require_validated(facts.unvalidated);
  return run_errors(facts, plan).limits;
}

ExpectedErrors expected_errors(const RunPlan& plan, const PlannedRun& run) {
  require_validated(plan.unvalidated);
  return run.errors.limits;
}

void add_expected_errors(ModelPlan& plan, double accepted, const std::function<ExpectedErrors()>& expected) {
  const std::string unknown = reason_against([&] { plan.expected = expected(); });
  if (!plan.expected) {
    plan.warnings.push_back({"error-unknown", "the error of this run is not known: " + unknown});
    return;
  }
  const ErrorEstimate& error = plan.expected->total;
  if (error.largest() <= accepted) return;
  plan.warnings.push_back(
      {"expected-error",
       fmt::format("the velocity is expected to be wrong by {} and the arm amplitudes by {}; beadswim-run {} "
                   "lists runs with smaller errors",
                   in_percent(error.velocity), in_percent(error.largest_of_arms()), Setting::plan)});
}

}  // namespace beadswim
