#include "beadswim/plan/expected_errors.hpp"

#include "beadswim/plan/run_length.hpp"
#include "beadswim/plan/velocity_roundoff.hpp"
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

}  // namespace

ExpectedErrors expected_errors(const Layout& layout, MobilityModel model, const MobilitySettings& settings,
                               double cycles) {
  const SceneFacts facts = scene_facts(layout, cycles);
  require_validated(facts);
  return {.total = mobility_scene_error(facts, model, settings).limit,
          .resolution = {.velocity = velocity_error_of_steps(model, settings) + position_roundoff(facts)},
          .wander = {},
          .box = box_changes(facts)};
}

ExpectedErrors expected_errors(const Layout& layout, const SceneOnLattice& on_lattice, double cycles) {
  const SceneFacts facts = scene_facts(layout, cycles);
  require_validated(facts);
  const long steps_per_cycle = on_lattice.lattice.steps_per_period;
  const double roundoff =
      velocity_roundoff(on_lattice.scene, steps_per_cycle, total_steps(cycles, steps_per_cycle));
  const LatticeErrors errors = lattice_scene_errors(on_lattice, facts, roundoff);
  return {.total = errors.total().limit,
          .resolution = errors.resolution.limit,
          .wander = errors.wander.limit,
          .box = box_changes(facts)};
}

}  // namespace beadswim
