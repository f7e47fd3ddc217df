#include "beadswim/plan/run_plan.hpp"

#include <fmt/core.h>

#include "beadswim/core/reason_against.hpp"
#include "beadswim/run/run_length.hpp"
#include "beadswim/run/velocity_roundoff.hpp"
#include "planned_scene.hpp"

namespace beadswim {
namespace {

ErrorEstimate box_changes(const SceneFacts& facts) {
  ErrorEstimate changes;
  for (const SwimmerFacts& swimmer_facts : facts.swimmer_facts) {
    const Question& question = swimmer_facts.representative.question;
    if (!question.box || !swimmer_facts.best) continue;
    Question open = question;
    open.box.reset();
    changes = componentwise_max(changes, difference(best_prediction(open), *swimmer_facts.best));
  }
  return changes;
}

ExpectedErrors lattice_errors(const SceneFacts& facts, const SceneOnLattice& on_lattice, double cycles) {
  const long steps_per_cycle = on_lattice.lattice.steps_per_period;
  const double roundoff =
      velocity_roundoff(on_lattice.scene, steps_per_cycle, total_steps(cycles, steps_per_cycle));
  const LatticeErrors errors = lattice_scene_errors(on_lattice, facts, roundoff);
  return {.total = errors.total().limit,
          .resolution = errors.resolution.limit,
          .wander = errors.wander.limit,
          .box = box_changes(facts)};
}

ExpectedErrors mobility_errors(const SceneFacts& facts, const RunSettings& settings) {
  const MobilityModel model = *mobility_model(settings.model);
  return {.total = mobility_scene_error(facts, model, settings.mobility).limit,
          .resolution = {.velocity =
                             velocity_error_of_steps(model, settings.mobility) + position_roundoff(facts)},
          .wander = {},
          .box = box_changes(facts)};
}

}  // namespace

ExpectedErrors expected_errors(const Layout& layout, const ModelPlan& plan) {
  const SceneFacts facts = scene_facts(layout, plan.settings.cycles);
  if (!facts.unvalidated.empty())
    throw InputError(
        fmt::format("error estimates have been validated for the paper's three-bead swimmers only, "
                    "not for the type \"{}\"; compare runs with different resolutions",
                    facts.unvalidated));
  return plan.lattice() != nullptr ? lattice_errors(facts, *plan.lattice(), plan.settings.cycles)
                                   : mobility_errors(facts, plan.settings);
}

void add_expected_errors(ModelPlan& plan, const Layout& layout, double accepted) {
  const std::string unknown = reason_against([&] { plan.expected = expected_errors(layout, plan); });
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
