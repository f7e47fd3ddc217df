#include "beadswim/plan/run_plan.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>

#include "beadswim/core/error.hpp"
#include "beadswim/core/joined.hpp"
#include "beadswim/core/reason_against.hpp"
#include "beadswim/core/setting.hpp"
#include "beadswim/coupling/lattice_memory.hpp"
#include "beadswim/scene/check.hpp"
#include "planned_scene.hpp"

namespace beadswim {
namespace {

constexpr double default_tolerance = 0.03;

/// Rejects runs that need more memory than the machines have. Collective.
void mark_runs_beyond_memory(std::vector<PlannedRun>& runs, const Communicator& communicator) {
  double bytes_of_rank = installed_bytes() / count_ranks_on_node(communicator);
  MPI_Allreduce(MPI_IN_PLACE, &bytes_of_rank, 1, MPI_DOUBLE, MPI_MIN, communicator.get());
  for (PlannedRun& run : runs) {
    const double needed = run.memory_bytes / communicator.size();
    if (run.refused.empty() && needed > bytes_of_rank)
      run.refused = fmt::format(
          "the run needs {:.3g} GB per rank, but only {:.3g} GB per rank are installed; use more machines, "
          "{} single, fewer {} or a smaller scene",
          1e-9 * needed, 1e-9 * bytes_of_rank, Setting::precision, Setting::cells_per_radius);
  }
}

/// Chooses the cheapest run within the tolerance and the run with the smallest error. Rejects runs whose
/// error is not finite. All ranks use the choice of rank 0. Collective.
void choose(RunPlan& plan, const Communicator& communicator) {
  constexpr int none = -1;
  std::array<int, 2> found{none, none};  // indices of the cheapest and of the most accurate run
  auto& [choice, best] = found;
  for (int r = 0; r < std::ssize(plan.runs); ++r) {
    PlannedRun& run = plan.runs[r];
    if (run.refused.empty() && !std::isfinite(run.errors.limits.total.largest() + run.core_seconds))
      run.refused = "the expected error or the cost of this run is not finite";
    if (!run.refused.empty()) continue;
    if (best == none || run.errors.limits.total.largest() < plan.runs[best].errors.limits.total.largest())
      best = r;
    if (run.errors.limits.total.largest() > plan.tolerance) continue;
    if (choice == none || run.core_seconds < plan.runs[choice].core_seconds) choice = r;
  }
  MPI_Bcast(found.data(), found.size(), MPI_INT, 0, communicator.get());
  if (choice != none) plan.choice = choice;
  if (best != none) plan.best = best;
}

/// Adds the difficulties of predicting the motion of one swimmer to `plan.hard`.
void add_hard_cases_of(RunPlan& plan, const SwimmerFacts& swimmer_facts) {
  const Question& question = swimmer_facts.representative.question;
  const BestPrediction& best = *swimmer_facts.best;
  const std::string who = fmt::format("swimmer {}", swimmer_facts.representative.swimmer);
  const auto add = [&](const std::string& what) { plan.hard.push_back(who + ": " + what); };
  if (const std::string film = film_obstacle(swimmer_facts); !film.empty()) add(film);
  if (!best.is_swimming) {
    add("the velocity is zero or only roundoff; error estimates are for the stroke alone");
  } else if (constexpr double much = 3; best.cancellation > much) {
    add(
        fmt::format("in this scene the swimmer reaches only 1/{:.2g} of the velocity with the same stroke in "
                    "open space, so relative errors of the velocity are large",
                    best.cancellation));
  }
  if (!swimmer_facts.representative.approximation.empty())
    add("error estimates are for a swimmer " + swimmer_facts.representative.approximation +
        ", because theory cannot treat the swimmer in this scene; to be safe, the limits of errors are "
        "doubled, except for the model unsteady");
  if (constexpr double tips_over = 20; swimmer_facts.tilt_growth > tips_over)
    add(fmt::format(
        "driving along a fixed direction compresses the swimmer for so long that a small tilt grows {:.2g} "
        "times and the swimmer turns over; a swimmer without any disturbance keeps its orientation",
        swimmer_facts.tilt_growth));
  reason_against([&] {  // an error is ignored here; the candidate reports it as PlannedRun::refused
    const ErrorEstimate stokes =
        estimate_of(mobility_error(question, best, MobilityModel::rpy_near, MobilitySettings{}).limit);
    if (stokes.largest() > plan.tolerance)
      add(
          fmt::format("inertia and other effects that mobility models neglect change the velocity by up to "
                      "{} and the arm amplitudes by up to {}",
                      in_percent(stokes.velocity), in_percent(stokes.largest_of_arms())));
  });
}

void add_hard_cases(RunPlan& plan, const SceneFacts& facts) {
  for (const SwimmerFacts& swimmer_facts : facts.swimmer_facts) {
    if (swimmer_facts.best) {
      add_hard_cases_of(plan, swimmer_facts);
    } else {
      plan.hard.push_back(
          fmt::format("swimmer {}: {}; error estimates include only errors by the cell size and by the delay "
                      "of stress and forces on the lattice",
                      swimmer_facts.representative.swimmer, film_obstacle(swimmer_facts)));
    }
  }
  if (!facts.unvalidated.empty())
    plan.hard.push_back(
        fmt::format("error estimates have not been validated for the type \"{}\": they are twice those of "
                    "three beads on a line with its largest radius, its mean bond length, its period and a "
                    "similar stroke, and often too small for mobility models without inertia; compare runs "
                    "with different resolutions",
                    facts.unvalidated));
  if (facts.cell.swimmers.size() > 1)
    plan.hard.push_back(
        "neighbours also move one another sideways; mobility models lack the part of this motion that "
        "inertia causes, and error estimates leave it out");
  if (constexpr double much = 1.5; facts.disorder_growth > much)
    plan.hard.push_back(
        fmt::format("small differences between swimmers grow {:.2g} times during the run, and the velocity "
                    "errors of single swimmers grow by the same factor",
                    facts.disorder_growth));
}

void add_proposals(RunPlan& plan, const Layout& layout, const SceneFacts& facts) {
  if (const int copies = facts.cells.prod(); copies > 1) {
    const Vec3 box = facts.cell.domain.box->lengths * facts.units.length;
    plan.proposals.push_back({fmt::format(
        "the scene consists of {} copies of a cell of {:g} x {:g} x {:g} with {} of the {} swimmers; a run "
        "of one such cell has 1/{} of the cost of a run of the scene",
        copies, box[0], box[1], box[2], facts.cell.swimmers.size(), layout.swimmers.size(), copies)});
  }
  const SwimmerFacts& swimmer_facts = facts.swimmer_facts.front();
  if (layout.swimmers.size() != 1 || is_simplified(swimmer_facts.representative) || !swimmer_facts.best)
    return;
  const std::optional<SufficientBox> box =
      sufficient_box(swimmer_facts.representative.question, plan.tolerance / 3);
  constexpr double worthwhile = 0.7;  // largest proposed volume, relative to the box of the layout
  const auto& present = facts.cell.domain.box;
  if (!box || (present && box->lengths.prod() > worthwhile * present->lengths.prod())) return;
  int along = 0;
  layout.swimmers.front().axis.cwiseAbs().maxCoeff(&along);
  Vec3 lengths;
  for (int a = 0; a < 3; ++a) lengths[(along + a) % 3] = box->lengths[a] * facts.units.length;
  plan.proposals.push_back(
      {fmt::format(
           "a single swimmer needs no larger box: theory predicts that this box changes velocity and stroke "
           "by at most {}, compared with the present layout",
           in_percent(box->change)),
       lengths});
}

}  // namespace

RunPlan plan_run(const Layout& layout, const PlanRequest& request, const std::string& source,
                 const Communicator& communicator) {
  RunPlan plan;
  plan.request = request;
  plan.tolerance = request.tolerance.value_or(default_tolerance);
  plan.ranks = communicator.size();
  const SceneFacts facts = scene_facts(layout, request.settings.cycles);
  plan.unvalidated = facts.unvalidated;
  const PlanInput input{layout, facts, request, source, communicator};
  plan.runs = mobility_runs(input);
  const bool has_lattices = request.allows(RunModel::lbm);
  if (has_lattices) std::ranges::move(lattice_runs(input), std::back_inserter(plan.runs));
  mark_runs_beyond_memory(plan.runs, communicator);
  choose(plan, communicator);
  if (!request.has_advice) return plan;
  const bool has_usual_cells = has_lattices && !request.settings.lattice.cells_per_radius;
  for (const std::string& text :
       {warning_of_fixed_forces(layout), has_usual_cells ? left_out_resolutions(layout) : ""})
    if (!text.empty()) plan.hard.push_back(text);
  add_hard_cases(plan, facts);
  if (!request.is_restart) add_proposals(plan, layout, facts);
  return plan;
}

const PlannedRun& choose_run(const RunPlan& plan) {
  if (plan.choice) return plan.runs[*plan.choice];
  if (!plan.best)
    throw InputError(Setting::plan, "no model can run this scene with these settings. {}",
                     joined(refusals(plan), ". "));
  const PlannedRun& best = plan.runs[*plan.best];
  if (plan.request.has_advice && !plan.request.tolerance) return best;
  throw InputError(Setting::tolerance,
                   "no run has an error limit within {}; the run with the smallest limit, {}, has a limit of "
                   "{}: raise the tolerance to that value{}",
                   in_percent(plan.tolerance), settings_text(best.settings, plan.request.chosen),
                   in_percent(best.errors.limits.total.largest()),
                   plan.request.is_restart
                       ? ""
                       : ", leave out settings that exclude other runs, or change the scene as a plan "
                         "proposes");
}

}  // namespace beadswim
