#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "beadswim/core/error.hpp"
#include "beadswim/core/joined.hpp"
#include "beadswim/core/reason_against.hpp"
#include "beadswim/core/setting.hpp"
#include "beadswim/coupling/lattice_memory.hpp"
#include "beadswim/coupling/refinement.hpp"
#include "beadswim/coupling/scene_on_lattice.hpp"
#include "beadswim/plan/lattice_speed.hpp"
#include "beadswim/run/run_length.hpp"
#include "beadswim/run/velocity_roundoff.hpp"
#include "beadswim/swimmers/swimmer_dynamics.hpp"
#include "planned_scene.hpp"

namespace beadswim {
namespace {

/// Cells per radius and relaxation times that a plan tries if the user sets none.
constexpr std::array usual_cells{2.0, 2.5, 3.0, 4.0, 5.0, 6.0, 8.0};
constexpr std::array usual_times{0.6, 0.8, 1.0, 1.5, 2.0};
constexpr double max_misfit =
    0.13;  // largest relative change of usual numbers of cells that fits them to the box

/// Returns numbers of cells per radius for which each edge of the box is an integer number of cells. They
/// differ from `usual_cells` by at most `max_misfit`. Multiples of 1/4 are preferred. Returns an empty list in
/// open space.
std::vector<double> commensurate_resolutions(const Layout& layout) {
  if (!layout.domain.box) return {};
  const Vec3 edges = layout.domain.box->lengths / smallest_radius(layout);
  const auto is_commensurate = [&](double cells) {
    constexpr double roundoff = 1e-9;  // relative deviation, as in put_on_lattice()
    return (cells * edges.array() - (cells * edges.array()).round()).abs().maxCoeff() <
           roundoff * cells * edges.maxCoeff();
  };
  std::vector<double> result;
  constexpr double max_cells = 1e6;  // number of cells along an edge, as in put_on_lattice()
  for (const double usual : usual_cells) {
    if (usual * edges.maxCoeff() > max_cells) break;
    constexpr double odd = 0.1;
    const auto penalty = [&](double cells) {
      const bool is_quarter = std::abs(4 * cells - std::round(4 * cells)) < 1e-9;
      return std::abs(cells / usual - 1) + (is_quarter ? 0 : odd);
    };
    double nearest = 0;
    const long first = std::lround(std::ceil(usual * (1 - max_misfit) * edges[0] - 1e-9));
    for (long n = first; static_cast<double>(n) <= usual * (1 + max_misfit) * edges[0]; ++n) {
      const double cells = static_cast<double>(n) / edges[0];
      if (is_commensurate(cells) && penalty(cells) < penalty(nearest)) nearest = cells;
    }
    if (nearest > 0 && (result.empty() || nearest > result.back())) result.push_back(nearest);
  }
  return result;
}

/// Returns the reason why the result of a run would be qualitatively wrong, even if put_on_lattice() accepts
/// its settings. Returns an empty string if there is no such reason.
std::string lattice_obstacle(const SceneOnLattice& on_lattice, double mach, double roundoff) {
  if (mach > max_incompressible_mach)
    return fmt::format(
        "the fastest bead would reach Mach {:.2g} (Mach 1: speed of sound of the lattice), where the fluid "
        "is compressible; use a smaller {} or more {}, or "
        "reduce the driving amplitude",
        mach, Setting::relaxation_time, Setting::cells_per_radius);
  if (on_lattice.density_on_lattice() < min_stable_density)
    return fmt::format(
        "the beads' density on the lattice is {:.2g} times the fluid's density, so the run may become "
        "unstable; use a larger {} or {} psm",
        on_lattice.density_on_lattice(), Setting::relaxation_time, Setting::bead_boundary);
  if (on_lattice.lattice.relaxation_time < min_stable_relaxation_time)
    return fmt::format(
        "the relaxation time {:.4g} is so close to 1/2 that viscosity hardly damps unresolved flow; use {} "
        "or more",
        on_lattice.lattice.relaxation_time, min_stable_relaxation_time);
  constexpr double contact = 0.1;  // [cell]; smaller gaps cause errors of 100 % (docs/hard-cases.md)
  if (on_lattice.smallest_gap < contact)
    return "beads touch or nearly touch at rest, so contact forces would determine the stroke; move the "
           "beads apart";
  if (!std::isfinite(roundoff))
    return fmt::format("the velocity would be only roundoff of single precision; use {} double",
                       Setting::precision);
  return {};
}

double largest_plane_factor(const CoupledScene& scene) {
  double factor = 1;
  for (const PlacedSwimmer& swimmer : scene.swimmers)
    factor = std::max(factor, lattice_plane_factor(swimmer.position, swimmer.orientation.col(0)));
  return factor;
}

/// Returns the Mach number of the fastest bead of all representatives.
double mach_of(const SceneOnLattice& on_lattice, const SceneFacts& facts) {
  double speed = 0;  // [SceneFacts::units]
  for (const SwimmerFacts& swimmer_facts : facts.swimmer_facts)
    speed = std::max(speed, swimmer_facts.representative.bead_speed);
  return speed * facts.units.velocity() * std::numbers::sqrt3 / on_lattice.lattice.scales.velocity();
}

void set_cost(PlannedRun& run, const CoupledScene& scene, const LatticeSpeed& speed, long steps, int ranks) {
  std::size_t beads = 0;
  for (const PlacedSwimmer& swimmer : scene.swimmers) beads += scene.types[swimmer.type].beads.size();
  run.core_seconds = static_cast<double>(steps) * speed.step(scene);
  run.memory_bytes = lattice_bytes(scene);
  complete_cost(run, beads, cells_on_levels(scene.all_levels()), ranks);
}

/// Returns the candidate (possible run) with these settings. `speed`: cost of lattice steps, measured by the
/// first candidate that needs it.
PlannedRun lattice_run(const PlanInput& input, const RunSettings& settings,
                       std::optional<LatticeSpeed>& speed) {
  const PlanRequest& request = input.request;
  PlannedRun run;
  run.settings = settings;
  std::string wrong;
  run.refused = reason_against([&] {
    require_settings_apply(request.chosen, settings.model);
    const SceneOnLattice on_lattice = put_on_lattice(input.layout, settings.lattice, input.source);
    for (const Block& level : on_lattice.scene.all_levels())
      run.cells.push_back(level.size.cast<std::int64_t>().prod());
    run.settings.lattice.refinement = static_cast<int>(run.cells.size()) - 1;
    // The call of substeps_for() throws if a type needs too many substeps.
    for (const SwimmerType& type : on_lattice.scene.types) substeps_for(type, 1);
    const long steps_per_cycle = on_lattice.lattice.steps_per_period;
    const long steps = total_steps(settings.cycles, steps_per_cycle);
    require_end_after(settings.cycles, steps, request.steps_done, steps_per_cycle);
    const double mach = mach_of(on_lattice, input.facts);
    const double roundoff = velocity_roundoff(on_lattice.scene, steps_per_cycle, steps);
    if (!speed) speed = request.lattice_speed();
    run.errors = lattice_run_errors(on_lattice, input.facts, roundoff);
    set_cost(run, on_lattice.scene, *speed, steps - request.steps_done, input.communicator.size());
    wrong = lattice_obstacle(on_lattice, mach, roundoff);
  });
  if (run.refused.empty()) run.refused = wrong;
  return run;
}

}  // namespace

RunErrors lattice_run_errors(const SceneOnLattice& on_lattice, const SceneFacts& facts, double roundoff) {
  const UnitScales& scales = on_lattice.lattice.scales;
  const ResolvedRun run{
      .cells_per_radius = on_lattice.resolution.cells_per_radius,
      .scheme = on_lattice.scene.bead_boundary,
      .smallest_gap = on_lattice.smallest_gap,
      .cell = scales.length / facts.units.length,
      .mach = mach_of(on_lattice, facts),
      .plane_factor = largest_plane_factor(on_lattice.scene),
      .timing = {.step = scales.time / facts.units.time,
                 .sound_speed = scales.velocity() / facts.units.velocity() / std::numbers::sqrt3,
                 .corrects_delay = on_lattice.scene.corrects_delay}};
  const auto by_resolution = [&](const SwimmerFacts& swimmer_facts) {
    if (!swimmer_facts.lag)
      throw InputError(
          "the expected error is unknown, because no method of theory predicts the motion of a swimmer: " +
          swimmer_facts.obstacle);
    return resolution_error(*swimmer_facts.lag, swimmer_facts.best, run);
  };
  const auto by_wander = [&](const SwimmerFacts& swimmer_facts) {
    return wander_error(swimmer_facts.best, run);
  };
  ErrorRange resolution = scene_error(facts, by_resolution);
  const ErrorRange wander = scene_error(facts, by_wander);
  if (resolution.limit[0] > 0 && std::isfinite(roundoff)) resolution.add_to_velocity(roundoff);
  if (resolution.limit[0] > 0 && !on_lattice.scene.levels.empty()) {
    // Twice the largest changes that were measured in free-slip boxes (docs/refinement.md).
    resolution.limit += MotionValues(0.0012, 0.0004, 0.0004);
  }
  const ErrorRange total = combined(resolution, wander);
  return {.limits = {.total = estimate_of(total.limit),
                     .resolution = estimate_of(resolution.limit),
                     .wander = estimate_of(wander.limit),
                     .box = estimate_of(facts.box_changes)},
          .typical = estimate_of(total.typical)};
}

std::string left_out_resolutions(const Layout& layout) {
  const std::vector<double> cells = commensurate_resolutions(layout);
  std::vector<double> left_out;
  std::ranges::copy_if(usual_cells, std::back_inserter(left_out), [&](double usual) {
    return std::ranges::none_of(cells,
                                [usual](double near) { return std::abs(near / usual - 1) < max_misfit + 1e-6; });
  });
  if (!layout.domain.box || left_out.empty()) return {};
  return fmt::format(
      "no lattice run has about {} cells per radius, because edges of the box would not be whole numbers of "
      "cells; whole numbers of cells fit if each edge is a multiple of the smallest radius, {:g}",
      joined(left_out, ", ", "{:g}"), smallest_radius(layout));
}

std::vector<PlannedRun> lattice_runs(const PlanInput& input) {
  const PlanRequest& request = input.request;
  const LatticeSettings& fixed = request.settings.lattice;
  std::vector<double> cells = commensurate_resolutions(input.layout);
  if (fixed.cells_per_radius) cells = {*fixed.cells_per_radius};
  if (cells.empty() && input.layout.resolution) cells = {input.layout.resolution->cells_per_radius};
  if (cells.empty()) cells = {4};
  std::vector<double> times(usual_times.begin(), usual_times.end());
  if (fixed.relaxation_time) times = {*fixed.relaxation_time};
  std::vector<Precision> precisions(all_values<Precision>.begin(), all_values<Precision>.end());
  if (request.is_fixed(Setting::precision)) precisions = {fixed.precision};
  std::optional<LatticeSpeed> speed;
  std::vector<PlannedRun> runs;
  for (const double cell : cells) {
    for (const double time : times) {
      for (const Precision precision : precisions) {
        RunSettings own = request.settings;
        own.model = RunModel::lbm;
        own.lattice.cells_per_radius = cell;
        own.lattice.relaxation_time = time;
        own.lattice.precision = precision;
        if (!request.is_fixed(Setting::refinement)) own.lattice.refinement.reset();
        runs.push_back(lattice_run(input, own, speed));
      }
    }
  }
  return runs;
}

}  // namespace beadswim
