#include "beadswim/plan/expected_errors.hpp"

#include "beadswim/coupling/scene_on_lattice.hpp"
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

ExpectedErrors expected_errors(const Layout& layout, const RunSettings& settings, const std::string& source) {
  const SceneFacts facts = scene_facts(layout, settings.cycles);
  ExpectedErrors errors;
  errors.box = box_changes(facts);
  if (const auto model = mobility_model(settings.model)) {
    errors.total = mobility_scene_error(facts, *model, settings.mobility);
    errors.resolution.velocity = velocity_error_of_steps(settings.mobility);
    return errors;
  }
  const SceneOnLattice on_lattice = put_on_lattice(layout, settings.lattice, source);
  const long steps_per_cycle = on_lattice.lattice.steps_per_period;
  const double roundoff =
      velocity_roundoff(on_lattice.scene, steps_per_cycle, total_steps(settings.cycles, steps_per_cycle));
  const LatticeErrors on_this_lattice = lattice_scene_errors(on_lattice, facts, roundoff);
  errors.total = on_this_lattice.total();
  errors.resolution = on_this_lattice.resolution;
  errors.wander = on_this_lattice.wander;
  return errors;
}

}  // namespace beadswim
