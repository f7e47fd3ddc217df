#include "planning/plan_flags.hpp"

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <map>
#include <regex>

#include "beadswim/core/error.hpp"
#include "beadswim/plan/percent.hpp"
#include "planning/lattice_speed_cache.hpp"

namespace beadswim {

PlanRequest plan_request(const RunOptions& options, const Communicator& communicator) {
  PlanRequest request;
  request.settings = options.settings;
  request.has_advice = options.plan;
  if (options.settings.model != RunModel::automatic) request.model = options.settings.model;
  const bool is_restart = !options.restart.empty();  // with the scene and the settings of its checkpoint
  request.may_change_scene = !is_restart;
  const auto is_fixed = [&](const char* flag) { return is_restart || options.given.contains(flag); };
  if (is_fixed("--precision")) request.precision = options.settings.lattice.precision;
  if (!is_fixed("--refine")) request.settings.lattice.refinement.reset();
  if (is_fixed("--multipole-order")) request.multipole_order = options.settings.mobility.multipole_order;
  request.tolerance = options.tolerance;
  request.require_choices_apply = [&options](const RunSettings& settings) {
    refuse_flags_of_other_models(options, settings.model);
  };
  request.lattice_speed = [&communicator] { return speed_of_this_machine(communicator); };
  return request;
}

std::string flags_of(const PlannedRun& run, const RunOptions& options) {
  const RunSettings& settings = run.settings;
  const LatticeSettings& lattice = settings.lattice;
  const LatticeSettings usual;
  std::string flags = "--model " + to_text(settings.model);
  if (settings.model == RunModel::lbm) {
    flags += fmt::format(" --cells-per-radius {} --relaxation-time {}", *lattice.cells_per_radius,
                         *lattice.relaxation_time);
    if (lattice.precision != usual.precision) flags += " --precision " + to_text(lattice.precision);
    if (lattice.bead_boundary != usual.bead_boundary)
      flags += " --bead-boundary " + to_text(lattice.bead_boundary);
    if (const int finer = lattice.refinement.value_or(0); finer != 0)
      flags += fmt::format(" --refine {}", finer);
  }
  if (const auto mobility = mobility_model(settings.model); mobility && has_moment_order(*mobility))
    flags += fmt::format(" --multipole-order {}", settings.mobility.multipole_order);
  const FlagValues course = result_flags(settings);
  for (const char* asked : {"--delay-correction", "--radius-correction", "--lubrication", "--friction",
                            "--sum-tolerance", "--steps-per-cycle", "--reynolds-stress"}) {
    if (const auto flag = course.find(asked); flag != course.end() && options.given.contains(asked))
      flags += fmt::format(" {} {}", asked, flag->second);
  }
  return flags;
}

std::vector<std::string> refusals(const RunPlan& plan, const RunOptions& options) {
  std::vector<const PlannedRun*> firsts;  // the first run of each reason
  std::map<std::string, int> runs;        // by reason, with # in place of numbers
  const std::regex number("[0-9][0-9.e+-]*");
  const auto kind = [&](const PlannedRun& run) { return std::regex_replace(run.refused, number, "#"); };
  for (const PlannedRun& run : plan.runs)
    if (!run.refused.empty() && ++runs[kind(run)] == 1) firsts.push_back(&run);
  std::vector<std::string> texts;
  for (const PlannedRun* run : firsts) {
    const int others = runs[kind(*run)] - 1;
    texts.push_back(
        fmt::format("{}{}: {}", flags_of(*run, options),
                    others > 0 ? fmt::format(", and {} similar run{}", others, others > 1 ? "s" : "") : "",
                    run->refused));
  }
  return texts;
}

const PlannedRun& choose_run(const RunPlan& plan, const RunOptions& options) {
  if (plan.choice) return plan.runs[*plan.choice];
  if (!plan.best)
    throw InputError("--plan", fmt::format("no model can run this scene with these flags. {}",
                                           fmt::join(refusals(plan, options), ". ")));
  const PlannedRun& best = plan.runs[*plan.best];
  if (options.plan && !options.tolerance) return best;
  throw InputError(
      "--tolerance",
      fmt::format(
          "no run has an error limit within {}; the run with the smallest limit, {}, has a limit of {}: "
          "raise the tolerance to that value{}",
          in_percent(plan.tolerance), flags_of(best, options), in_percent(best.error.limit.largest()),
          options.restart.empty()
              ? ", leave out flags that exclude other runs, or change the scene as --plan proposes"
              : ""));
}

}  // namespace beadswim
