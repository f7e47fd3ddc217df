#include "run_plan.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <iterator>

#include "beadswim/core/error.hpp"
#include "beadswim/plan/sufficient_box.hpp"
#include "memory.hpp"
#include "planned_scene.hpp"

namespace beadswim {
namespace {

constexpr double usual_tolerance = 0.03;

/// Marks runs that need more memory than the nodes have. Collective.
void refuse_what_does_not_fit(std::vector<PlannedRun>& runs, const Communicator& communicator) {
  double bytes_of_rank = installed_bytes() / ranks_on_this_node(communicator);
  MPI_Allreduce(MPI_IN_PLACE, &bytes_of_rank, 1, MPI_DOUBLE, MPI_MIN, communicator.get());
  for (PlannedRun& run : runs) {
    const double needed = run.memory_bytes / communicator.size();
    if (run.refused.empty() && needed > bytes_of_rank)
      run.refused =
          fmt::format("needs more than the {:.3g} GB that there are for a rank", 1e-9 * bytes_of_rank);
  }
}

void choose(RunPlan& plan) {
  for (std::size_t r = 0; r < plan.runs.size(); ++r) {
    const PlannedRun& run = plan.runs[r];
    if (!run.refused.empty()) continue;
    if (!plan.best || run.error.largest() < plan.runs[*plan.best].error.largest()) plan.best = r;
    if (run.error.largest() > plan.tolerance) continue;
    if (!plan.choice || run.core_seconds < plan.runs[*plan.choice].core_seconds) plan.choice = r;
  }
}

std::string percent(double share) {
  return fmt::format("{:.2g} %", 100 * share);
}

/// What is hard about a swimmer's velocity and surroundings.
void add_hard_cases_of(RunPlan& plan, const Asked& asked) {
  const Question& question = asked.representative.question;
  const BestKnown& best = *asked.best;
  const std::string who = fmt::format("swimmer {}", asked.representative.swimmer);
  const auto add = [&](const std::string& what) { plan.hard.push_back(who + ": " + what); };
  if (const std::string film = film_between_beads(asked); !film.empty()) add(film);
  if (!best.swims) {
    add("does not swim, or by no more than roundoff; errors are of strokes alone");
  } else if (constexpr double much = 3; best.cancellation > much) {
    add(
        fmt::format("its velocity is a small difference, 1/{:.2g} of what the same stroke makes in open "
                    "space, and errors "
                    "of it are large",
                    best.cancellation));
  }
  if (!asked.representative.is_exact)
    add("estimated as one swimmer in its share of the box, along its own line, and doubled: theory does not "
        "know "
        "neighbours that differ, slant or no-slip walls");
  try {
    const ErrorEstimate stokes = mobility_error(question, best, MobilityModel::rpy_near);
    const auto& [first, second] = stokes.arm_amplitudes;
    if (stokes.largest() > plan.tolerance)
      add(fmt::format("inertia, and what no mobility model knows, change v by up to {} and arms by up to {}",
                      percent(stokes.velocity), percent(std::max(first, second))));
  } catch (const InputError&) {  // no motion of the model: its row says so
  }
}

void add_hard_cases(RunPlan& plan, const SceneFacts& facts) {
  for (const Asked& asked : facts.asked) {
    if (asked.best) {
      add_hard_cases_of(plan, asked);
    } else {
      plan.hard.push_back(
          fmt::format("swimmer {}: {}, and estimates are of the lattice's lag and cells alone",
                      asked.representative.swimmer, film_between_beads(asked)));
    }
  }
  if (constexpr double tips_over = 20; facts.turning > tips_over)
    plan.hard.push_back(fmt::format(
        "driving along fixed axes presses swimmers together for so long that a tilt grows {:.2g} times, and "
        "they turn over; a straight one stays so until something disturbs it",
        facts.turning));
  if (constexpr double much = 1.5; facts.disorder > much)
    plan.hard.push_back(fmt::format(
        "swimmers that differ part from their order: departures grow {:.2g} times in the run, and "
        "errors of single swimmers with them",
        facts.disorder));
}

void add_proposals(RunPlan& plan, const Layout& layout, const SceneFacts& facts) {
  if (const int copies = facts.cells.prod(); copies > 1) {
    const Vec3& box = facts.cell.domain->lengths;
    plan.proposals.push_back(
        {fmt::format(
             "the scene is {} times a cell of {:g} x {:g} x {:g} with {} of {} swimmers, at 1/{} of the cost",
             copies, box[0], box[1], box[2], facts.cell.swimmers.size(), layout.swimmers.size(), copies),
         "beadswim-layout reduce"});
  }
  const Asked& asked = facts.asked.front();
  if (layout.swimmers.size() != 1 || !asked.representative.is_exact || !asked.best) return;
  const double third = plan.tolerance / 3;
  const std::optional<SufficientBox> box = sufficient_box(asked.representative.question, third);
  constexpr double worthwhile = 0.7;
  if (!box || (layout.domain && box->lengths.prod() > worthwhile * layout.domain->lengths.prod())) return;
  plan.proposals.push_back(
      {fmt::format("alone, the swimmer needs no larger box than {:g} x {:g} x {:g}, along it and across: "
                   "theory finds {} of "
                   "change in velocity and strokes",
                   box->lengths[0], box->lengths[1], box->lengths[2], percent(box->change)),
       fmt::format("beadswim-layout swimmer --box {:g},{:g},{:g} --boundary periodic", box->lengths[0],
                   box->lengths[1], box->lengths[2])});
}

}  // namespace

std::string flags_of(const PlannedRun& run) {
  const RunOptions& o = run.options;
  if (o.model != "lbm") return "--model " + o.model;
  const RunOptions usual;
  return fmt::format("--model lbm --cells-per-radius {} --relaxation-time {}", *o.cells_per_radius,
                     *o.relaxation_time) +
         (o.precision != usual.precision ? " --precision " + name_of(o.precision) : "") +
         (o.bead_boundary != usual.bead_boundary ? " --bead-boundary " + name_of(o.bead_boundary) : "");
}

RunPlan plan_run(const Layout& layout, const RunOptions& options, const std::string& source,
                 const Communicator& communicator) {
  RunPlan plan;
  plan.tolerance =
      options.given.contains("--tolerance") && options.model == "auto" ? options.tolerance : usual_tolerance;
  const SceneFacts facts = facts_of(layout, options.cycles);
  plan.runs = mobility_runs(layout, facts, options, source, communicator);
  if (options.model == "auto" || options.model == "lbm")
    std::ranges::move(lattice_runs(layout, facts, options, source, communicator),
                      std::back_inserter(plan.runs));
  refuse_what_does_not_fit(plan.runs, communicator);
  choose(plan);
  add_hard_cases(plan, facts);
  add_proposals(plan, layout, facts);
  return plan;
}

const PlannedRun& chosen(const RunPlan& plan) {
  if (plan.choice) return plan.runs[*plan.choice];
  if (!plan.best)
    throw InputError("--tolerance",
                     "no model can run this scene; beadswim-run --plan says why not, one by one");
  const PlannedRun& best = plan.runs[*plan.best];
  throw InputError(
      "--tolerance",
      fmt::format("no run is expected to be within {}; the best, {}, is within {}: allow that, or change "
                  "the scene as beadswim-run --plan proposes",
                  percent(plan.tolerance), flags_of(best), percent(best.error.largest())));
}

}  // namespace beadswim
