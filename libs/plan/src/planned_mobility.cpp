#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <set>

#include "beadswim/core/error.hpp"
#include "beadswim/core/reason_against.hpp"
#include "beadswim/coupling/lattice_memory.hpp"
#include "beadswim/mobility/force_moments.hpp"
#include "beadswim/overdamped/overdamped_setup.hpp"
#include "beadswim/run/run_length.hpp"
#include "planned_scene.hpp"

namespace beadswim {
namespace {

/// Core-seconds of one product of the mobility matrix and the forces on all beads, and of the end of a time
/// step with memory of the fluid.
struct StepCost {
  double product = 0, end_of_step = 0;
};

/// Returns the number of points of the mesh of a fluid with memory.
double mesh_points(const OverdampedScene& scene) {
  return (mirrored_lengths(scene.domain.box) / scene.memory->spacing).prod();
}

/// Returns the number of fields on this mesh: one per degree of moments and radius.
double mesh_fields(const OverdampedScene& scene) {
  std::set<double> radii;
  for (const double radius : bead_radii(scene)) radii.insert(radius);
  return (scene.moment_order + 1.0) * static_cast<double>(std::min(radii.size(), max_exact_radii));
}

/// Returns the memory for the mesh and the modes of a fluid with memory [byte]. docs/results/plan-costs.sh
/// measured 62, 114, 132 and 158 bytes per point where this is 66, 114, 138 and 162.
double mesh_bytes(const OverdampedScene& scene) {
  if (!scene.memory) return 0;
  const double bytes_per_point = 24 * mesh_fields(scene) + (scene.memory->has_reynolds_stress ? 90 : 42);
  return bytes_per_point * mesh_points(scene);
}

/// Returns the cost with memory of the fluid, without measuring it on a large mesh. The numbers agree within
/// 30 % with products and cycles of 34,560 beads, which beadswim-bench and runs have measured
/// (docs/performance.md).
StepCost estimated_cost(const OverdampedScene& scene) {
  // Computing time of one sum, per point of the mesh of the Reynolds stress and field, and per bead
  // [core-seconds]. It increases with the size of the mesh, which exceeds the caches.
  const double points = mesh_points(scene), growth = std::pow(points / 2e5, 0.15);
  constexpr std::array<double, 3> seconds_per_bead{9e-7, 5e-6, 1.5e-5};
  const double sum = 1.1e-8 * growth * points * mesh_fields(scene) +
                     seconds_per_bead[scene.moment_order] * static_cast<double>(bead_radii(scene).size());
  // Moments are found by iteration. At the end of a step, forces and moments are transformed once more.
  const double stress = scene.memory->has_reynolds_stress ? 3e-8 * growth * points : 0;
  return {.product = (scene.moment_order > 0 ? 1.7 : 1) * sum, .end_of_step = 0.5 * sum + stress};
}

/// Measures the cost of products with forces that oscillate. Collective.
StepCost measured_cost(const OverdampedScene& scene, const Communicator& communicator) {
  const Beads places = start_positions(scene);
  Beads forces(places.size()), velocities(places.size());
  Mobility product(mobility_scene(scene), places, communicator);
  std::vector<double> moments;  // of the last product, from which the next one begins
  int count = 0;
  StepCost cost;
  const auto evaluate = [&] {
    const double factor = std::cos(2 * std::numbers::pi / 100 * count++);
    for (std::size_t b = 0; b < forces.size(); ++b)
      forces[b] = Vec3::UnitX() * (b % 3 == 1 ? -2 : 1) * factor;
    const double begin = MPI_Wtime();
    product.set_positions(places);
    product.apply(forces, velocities, FlowPart::all, {.moments = moments});
    moments.assign(product.moments().begin(), product.moments().end());
    const double middle = MPI_Wtime();
    if (scene.memory) product.end_step(product.moments(), Vec3::Zero());
    cost.product += middle - begin;
    cost.end_of_step += MPI_Wtime() - middle;
  };
  evaluate();  // the first products also prepare tables
  if (scene.memory) evaluate();
  const auto measure = [&](int products) {
    cost = {};
    MPI_Barrier(communicator.get());
    for (int n = 0; n < products; ++n) evaluate();
    MPI_Barrier(communicator.get());
    cost = {.product = communicator.size() * cost.product / products,
            .end_of_step = communicator.size() * cost.end_of_step / products};
    MPI_Bcast(&cost, sizeof(StepCost), MPI_BYTE, 0, communicator.get());
    return cost.product / communicator.size();
  };
  const double once = measure(1);
  constexpr double timing_interval = 0.02;
  if (once <= timing_interval) measure(static_cast<int>(timing_interval / once) + 1);
  return cost;
}

/// Sets the cost of the candidate `run`: core-seconds for products of mobility matrix and forces and for
/// other work of each step, memory and disk space (docs/method/mobility-swarms.md, docs/performance.md).
void set_cost(PlannedRun& run, const OverdampedSetup& setup, long steps_done,
              const Communicator& communicator) {
  // Counted and measured by docs/results/plan-costs.sh; bytes per bead without moments by beadswim-bench
  // (docs/performance.md).
  const bool is_alone = setup.scene.swimmers.size() == 1 && !setup.scene.domain.box,
             has_memory = setup.scene.memory.has_value();
  const double first_products = has_memory ? 6 : is_alone ? 13 : 26;
  double products_per_step = is_alone ? 1 : 1.3;
  if (has_memory) products_per_step = setup.scene.moment_order == 0 ? 1.1 : 1.2;
  constexpr double rest_of_step = 1e-5;                             // per swimmer and step [s]
  constexpr double bytes_in_box = 800, bytes_in_open = 3100;        // per bead, including the mesh [byte]
  constexpr std::array<double, 3> bytes_of_moments{0, 4400, 6600};  // per bead or mirror image, on each rank
  const int order = setup.scene.model == MobilityModel::rpy_near ? 1 : setup.scene.moment_order;
  const std::size_t beads = bead_radii(setup.scene).size();
  const double swimmers = static_cast<double>(beads) / 3;  // of three beads each
  const long all_steps = total_steps(run.settings.cycles, setup.steps_per_cycle);
  require_end_after(run.settings.cycles, all_steps, steps_done, setup.steps_per_cycle);
  const double steps = static_cast<double>(all_steps - steps_done);
  constexpr double max_measured_points = 1e5;
  const bool is_large = has_memory && mesh_points(setup.scene) > max_measured_points;
  const StepCost cost = is_large ? estimated_cost(setup.scene) : measured_cost(setup.scene, communicator);
  run.core_seconds = rest_of_step * swimmers * steps +
                     (products_per_step * steps + first_products) * cost.product + steps * cost.end_of_step;
  run.memory_bytes = static_cast<double>(beads) * (setup.scene.domain.box ? bytes_in_box : bytes_in_open) +
                     std::ldexp(static_cast<double>(beads), mirror_count(setup.scene.domain.box)) *
                         bytes_of_moments[order] * communicator.size() +
                     mesh_bytes(setup.scene);
  complete_cost(run, beads, 0, communicator.size());
}

PlannedRun mobility_run(const PlanInput& input, MobilityModel model, int multipole_order) {
  PlannedRun run;
  run.settings = input.request.settings;
  run.settings.model = run_model(model);
  run.settings.mobility.multipole_order = multipole_order;
  run.refused = reason_against([&] {
    require_settings_apply(input.request.chosen, run.settings.model);
    const MobilitySettings& settings = run.settings.mobility;
    const OverdampedSetup setup =
        overdamped_setup(input.layout, model, settings, run.settings.frames_per_cycle, input.source);
    run.errors = mobility_run_errors(input.facts, model, settings);
    if (const double needed = mesh_bytes(setup.scene); needed > installed_bytes())
      throw InputError(fmt::format(
          "the mesh of the fluid's memory needs {:.3g} GB, more than this machine has", 1e-9 * needed));
    set_cost(run, setup, input.request.steps_done, input.communicator);
  });
  return run;
}

/// Returns the largest relative error of the velocity v of a mobility run by the roundoff of bead positions
/// x. Each of the n steps of a period T rounds x by a random number of standard deviation eps |x|/sqrt(12).
/// Two standard deviations of the mean displacement of three beads are
///
///   2 eps |x| sqrt(n/12/3),   relative to the displacement T |v|
double position_roundoff(const SceneFacts& facts, const MobilitySettings& settings) {
  const double steps = settings.steps_per_cycle.value_or(MobilitySettings::default_steps_per_cycle);
  double largest = 0;
  for (const SwimmerFacts& swimmer_facts : facts.swimmer_facts) {
    if (!swimmer_facts.best || !swimmer_facts.best->is_swimming) continue;
    const CollinearSwimmer& swimmer = swimmer_facts.representative.question.line();
    double farthest = swimmer.arm[0] + swimmer.arm[1];
    if (const auto& box = facts.cell.domain.box)
      farthest = std::max(farthest, (box->lengths.array() * facts.cells.cast<double>()).maxCoeff());
    for (const Swimmer& placed : facts.cell.swimmers)
      farthest = std::max(farthest, placed.position.cwiseAbs().maxCoeff());
    const double rounded = 2 * std::numeric_limits<double>::epsilon() * farthest * std::sqrt(steps / 36);
    largest = std::max(largest, rounded / (swimmer.period * std::abs(swimmer_facts.best->velocity())));
  }
  return largest;
}

}  // namespace

RunErrors mobility_run_errors(const SceneFacts& facts, MobilityModel model,
                              const MobilitySettings& settings) {
  for (const SwimmerFacts& swimmer_facts : facts.swimmer_facts)
    if (const std::string film = film_obstacle(swimmer_facts); !film.empty()) throw InputError(film);
  const auto error_of = [&](const SwimmerFacts& swimmer_facts) {
    return mobility_error(swimmer_facts.representative.question, *swimmer_facts.best, model, settings);
  };
  const double roundoff = position_roundoff(facts, settings);
  ErrorRange error = scene_error(facts, error_of, model != MobilityModel::unsteady);
  error.add_to_velocity(error_near_wall(facts.height, model, settings) + roundoff);
  return {.limits = {.total = estimate_of(error.limit),
                     .resolution = {.velocity = velocity_error_of_steps(model, settings) + roundoff},
                     .wander = {},
                     .box = estimate_of(facts.box_changes)},
          .typical = estimate_of(error.typical)};
}

std::vector<PlannedRun> mobility_runs(const PlanInput& input) {
  const PlanRequest& request = input.request;
  std::vector<PlannedRun> runs;
  const int usual_order = request.settings.mobility.multipole_order;
  const auto may_have = [&](int order) {
    return order == usual_order || !request.is_fixed(Setting::multipole_order);
  };
  const auto add_run = [&](MobilityModel model, int order) {
    if (request.allows(run_model(model))) runs.push_back(mobility_run(input, model, order));
  };
  for (const MobilityModel model : {MobilityModel::oseen, MobilityModel::rpy, MobilityModel::rpy_near})
    add_run(model, usual_order);
  if (request.settings.model == RunModel::multipole) {
    add_run(MobilityModel::multipole, usual_order);
  } else if (input.layout.domain.half_space ||
             !input.layout.flow.is_zero()) {  // the model unsteady lacks them
    for (int order = 1; order <= max_moment_order; ++order)
      if (may_have(order)) add_run(MobilityModel::multipole, order);
  }
  for (int order = 0; order <= max_moment_order; ++order)
    if (may_have(order)) add_run(MobilityModel::unsteady, order);
  return runs;
}

}  // namespace beadswim
