#include "beadswim/coupling/scene_on_lattice.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "beadswim/core/error.hpp"
#include "beadswim/core/setting.hpp"
#include "beadswim/coupling/bead_exchange.hpp"
#include "beadswim/coupling/refinement.hpp"
#include "beadswim/lattice/trt.hpp"
#include "beadswim/scene/bead_gaps.hpp"
#include "beadswim/scene/placed_swimmers.hpp"
#include "beadswim/swimmers/swimmer_shape.hpp"

namespace beadswim {
namespace {

/// Resolution if neither the settings nor the layout specify it. docs/speed-against-error.md explains the
/// choice.
constexpr Resolution default_resolution{.cells_per_radius = 4, .relaxation_time = 1};

/// Smallest permitted radius of a bead [cell]. A smaller bead may contain no cell centre, so that it covers
/// no cell.
constexpr double smallest_bead = 1;

void require_box(const Layout& layout, const std::string& source) {
  if (!layout.flow.is_zero())
    throw InputError(source + ":/flow",
                     "a background flow is unbounded, but a lattice ends at its box; use {} rpy or "
                     "multipole, or no-slip walls that move or a body force",
                     Setting::model);
  if (layout.domain.half_space)
    throw InputError(source + ":/domain/half_space",
                     "a half-space is unbounded, but a lattice needs a box; use {} rpy or multipole, or a "
                     "box with the boundary no-slip along {}, high above the swimmers",
                     Setting::model, "xyz"[layout.domain.half_space->axis]);
  if (layout.domain.box) return;
  throw InputError(source + ":/domain",
                   "the domain is null (unbounded fluid), but a lattice needs a box; make the layout with {} "
                   "X,Y,Z and {}, or use {} rpy or beadswim-theory",
                   Setting::box, Setting::boundary, Setting::model);
}

void require_off_walls(const Layout& layout, double cell, const std::string& source) {
  for (const PlacedBead& bead : placed_beads(layout)) {
    for (int a = 0; a < 3; ++a) {
      if (layout.domain.box->is_periodic(a)) continue;
      const double to_wall = std::min(bead.centre[a], layout.domain.box->lengths[a] - bead.centre[a]);
      const double gap = to_wall - bead.radius;
      if (gap >= min_wall_gap * cell) continue;
      throw InputError(fmt::format("{}:/swimmers/{}/position", source, bead.swimmer),
                       "bead {} has a gap of {:.3g} to a wall perpendicular to {}; the gap must be at least "
                       "half a cell, {:.3g}; move the swimmer or use more {}",
                       bead.bead + 1, gap, "xyz"[a], min_wall_gap * cell, Setting::cells_per_radius);
    }
  }
}

/// Throws InputError if the relaxation time is below min_stable_relaxation_time and the scheme has links. The
/// links are then unstable, or the relative errors of stroke amplitudes reach 50 %.
void require_viscosity(BeadScheme scheme, double relaxation_time) {
  if (!has_links(scheme) || relaxation_time >= min_stable_relaxation_time) return;
  throw InputError(Setting::relaxation_time,
                   "the relaxation time {:.6g} is so close to 1/2 that the flow at bead surfaces is unstable "
                   "with {} {}; use {} or more, or {} psm",
                   relaxation_time, Setting::bead_boundary, to_text(scheme), min_stable_relaxation_time,
                   Setting::bead_boundary);
}

/// Throws InputError near the relaxation time at which multireflection is undefined (link_laws.hpp).
void require_slip(BeadScheme scheme, double relaxation_time) {
  constexpr double nearest = 1e-4;
  const double antisymmetric_time = 1 / relaxation_rates(relaxation_time).antisymmetric;
  if (scheme != BeadScheme::mr || std::abs(1 - antisymmetric_time) > nearest) return;
  throw InputError(Setting::relaxation_time,
                   "the relaxation time {:.6g} makes the correction of multireflection ({} mr) undefined; "
                   "use 0.87 or 0.88, or another {}",
                   relaxation_time, Setting::bead_boundary, Setting::bead_boundary);
}

Index3 whole_cells(const Vec3& lengths, double cell, const std::string& source) {
  constexpr double roundoff = 1e-9, max_cells = 1e6;
  Index3 cells;
  for (int a = 0; a < 3; ++a) {
    const double exact = lengths[a] / cell;
    const double whole = std::round(exact);
    const std::string place = fmt::format("{}:/domain/lengths/{}", source, a);
    if (whole > max_cells)
      throw InputError(
          place, "the box length {} is {:.3g} cells, above the limit of {}; use a smaller box or fewer {}",
          lengths[a], exact, max_cells, Setting::cells_per_radius);
    if (whole < 1 || std::abs(exact - whole) > roundoff * whole) {
      throw InputError(place,
                       "the box length {} is {:.6g} cells of size {:.6g}, not a whole number; the nearest "
                       "lengths are {:.10g} and {:.10g}; use one of these lengths or another {}",
                       lengths[a], exact, cell, std::max(1.0, std::floor(exact)) * cell,
                       (std::floor(exact) + 1) * cell, Setting::cells_per_radius);
    }
    cells[a] = static_cast<int>(whole);
  }
  return cells;
}

/// Largest permitted speed of walls and of the flow that a body force drives [cell/step]. The relative error
/// of the flow is of order 3 speed^2.
constexpr double max_flow_speed = 0.1;

/// Throws InputError if a wall moves so fast that the fluid is compressed.
void require_slow_walls(const std::array<WallVelocities, 3>& walls, const std::string& source) {
  for (int a = 0; a < 3; ++a) {
    const double speed = std::max(walls[a].lower.norm(), walls[a].upper.norm());
    if (speed <= max_flow_speed) continue;
    throw InputError(fmt::format("{}:/domain/boundary/{}", source, a),
                     "a wall moves by {:.3g} cells in a time step, but only {} are permitted; use a smaller "
                     "{} or more {}, or a slower wall",
                     speed, max_flow_speed, Setting::relaxation_time, Setting::cells_per_radius);
  }
}

/// Throws InputError if the body force drives a flow that is so fast that the fluid is compressed. The flow
/// between the two nearest no-slip walls is not faster than plane Poiseuille flow, g h^2/(8 nu).
void require_slow_flow(const CoupledScene& scene, double relaxation_time, const std::string& source) {
  double height = std::numeric_limits<double>::infinity();
  for (int a = 0; a < 3; ++a)
    if (scene.boundary[a] == Boundary::no_slip)
      height = std::min(height, static_cast<double>(scene.cells[a]));
  const double force = scene.body_force.norm();
  if (force == 0) return;
  const double speed = force * height * height / (8 * lattice_viscosity(relaxation_time));
  if (speed <= max_flow_speed) return;
  throw InputError(source + ":/body_force",
                   "the fluid would move by {:.3g} cells in a time step, but only {} are permitted; use a "
                   "smaller {} or more {}, or a smaller body force",
                   speed, max_flow_speed, Setting::relaxation_time, Setting::cells_per_radius);
}

/// Returns the lattice for a layout. Throws InputError if beads are too small or time steps too long.
LatticeChoice lattice_for(const Layout& layout, const Resolution& resolution, double period, long multiple) {
  constexpr double latest = 0.3;  // largest permitted delay of the force of the fluid, as a phase [rad]
  const LatticeChoice lattice =
      choose_lattice(smallest_radius(layout), resolution, layout.fluid, period, multiple);
  if (resolution.cells_per_radius < smallest_bead) {
    throw InputError(Setting::cells_per_radius,
                     "with {} cells per radius, a bead may cover no cell at all; use at least {} cells per "
                     "radius, or 3 or more to resolve the beads",
                     resolution.cells_per_radius, smallest_bead);
  }
  const double steps = shortest_period(layout) / lattice.scales.time;
  const double late = 2 * std::numbers::pi * force_delay(lattice.relaxation_time) / steps;
  if (late <= latest) return lattice;
  throw InputError(Setting::relaxation_time,
                   "the relaxation time {} makes the time step so long that a period has {:.6g} steps and "
                   "the force of the fluid is late by a phase of {:.2g} rad; strokes would be wrong by as "
                   "much or more. A delay of at most {} rad is allowed: use a smaller {} or more {}",
                   resolution.relaxation_time, steps, late, latest, Setting::relaxation_time,
                   Setting::cells_per_radius);
}

/// Adds the swimmers of the layout and their types to the scene, in lattice units.
void add_swimmers(CoupledScene& scene, const Layout& layout, const LatticeChoice& lattice,
                  bool corrects_delay) {
  Swarm swarm = placed_swimmers(layout);
  for (SwimmerType& type : swarm.types) {
    type = in_units(type, lattice.scales);
    for (Bead& bead : type.beads)
      if (corrects_delay) bead.density += delay_density(bead, lattice.relaxation_time);
  }
  for (PlacedSwimmer& swimmer : swarm.swimmers) {
    swimmer.position /= lattice.scales.length;
    for (Vec3& bead : swimmer.start) bead /= lattice.scales.length;
  }
  static_cast<Swarm&>(scene) = std::move(swarm);
}

/// Returns the largest number of levels below the coarsest with which a period of `steps` steps changes by at
/// most 1 % when it is rounded to a multiple of the coarsest step.
int finer_levels_of_period(long steps) {
  constexpr long min_coarsest_steps = 50;
  int finer = 0;
  while (finer < max_finer_levels && steps >> (finer + 1) >= min_coarsest_steps) ++finer;
  return finer;
}

/// Returns the levels of the scene; nothing if one level is the choice. Throws InputError if `refinement`
/// levels below the coarsest do not fit. steps: number of steps in a period.
std::vector<Block> chosen_levels(const CoupledScene& scene, const std::optional<int>& refinement,
                                 long steps) {
  const int finer_in_period = finer_levels_of_period(steps);
  if (!refinement) return cheapest_levels(scene, finer_in_period + 1);
  const auto levels = levels_around(scene, bead_extent(scene), *refinement + 1);
  if (levels && *refinement <= finer_in_period) return *levels;
  const int max_finer = std::min(max_levels(scene) - 1, finer_in_period);
  const std::string choice = max_finer == 0 ? fmt::format("use {} off", Setting::refinement)
                                            : fmt::format("use at most {}", max_finer);
  if (levels)
    throw InputError(
        Setting::refinement,
        "with {} finer levels, the coarsest would have only {} steps per period; {}, or a smaller {}",
        *refinement, steps >> *refinement, choice, Setting::relaxation_time);
  throw InputError(Setting::refinement,
                   "{} finer levels do not fit into the box of {} x {} x {} cells: each edge must be a whole "
                   "number of coarsest cells, and levels keep a distance to walls; {}, or another {} or {}",
                   *refinement, scene.cells[0], scene.cells[1], scene.cells[2], choice, Setting::box,
                   Setting::cells_per_radius);
}

}  // namespace

LatticeChoice choose_lattice(double radius, const Resolution& resolution, const Fluid& fluid, double period,
                             long multiple) {
  const double cell = radius / resolution.cells_per_radius, nu = fluid.kinematic_viscosity;
  const double viscous_step = lattice_viscosity(resolution.relaxation_time) * cell * cell / nu;
  const long steps =
      multiple * std::max(1L, std::lround(period / viscous_step / static_cast<double>(multiple)));
  const double step = period / static_cast<double>(steps);
  return {.scales = {.length = cell, .time = step, .density = fluid.density},
          .relaxation_time = relaxation_time_of(nu * step / (cell * cell)),
          .steps_per_period = steps};
}

double SceneOnLattice::angular_softening() const {
  double smallest = 1;
  for (const std::vector<double>& of_type : softening)
    for (const double ratio : of_type) smallest = std::min(smallest, ratio);
  return smallest;
}

double SceneOnLattice::density_on_lattice() const {
  double least = std::numeric_limits<double>::infinity();
  for (const SwimmerType& type : scene.types) {
    for (const Bead& bead : type.beads) least = std::min(least, bead.density);
  }
  return least;
}

SceneOnLattice put_on_lattice(const Layout& layout, const LatticeSettings& settings,
                              const std::string& source) {
  require_box(layout, source);
  if (layout.fluid.thermal_energy > 0)
    throw InputError(source + ":/fluid/thermal_energy", "the lattice lacks thermal noise; use {}",
                     models_with_noise(layout));
  const Resolution hint = layout.resolution.value_or(default_resolution);
  SceneOnLattice result;
  result.period = base_period(layout);
  result.resolution = {.cells_per_radius = settings.cells_per_radius.value_or(hint.cells_per_radius),
                       .relaxation_time = settings.relaxation_time.value_or(hint.relaxation_time)};
  result.lattice = lattice_for(layout, result.resolution, result.period, 1);
  const UnitScales& scales = result.lattice.scales;
  require_off_walls(layout, scales.length, source);

  CoupledScene& scene = result.scene;
  scene.precision = settings.precision;
  scene.bead_boundary = settings.bead_boundary;
  scene.corrects_delay = settings.delay_correction;
  scene.corrects_radii = settings.radius_correction;
  scene.lubrication = settings.lubrication;
  scene.friction = settings.friction;
  scene.cells = whole_cells(layout.domain.box->lengths, scales.length, source);
  scene.boundary = layout.domain.box->boundary;
  add_swimmers(scene, layout, result.lattice, settings.delay_correction);
  if (settings.refinement != 0)
    scene.levels = chosen_levels(scene, settings.refinement, result.lattice.steps_per_period);
  if (!scene.levels.empty()) {  // all levels must reach the end of a period at the same time
    result.lattice = lattice_for(layout, result.resolution, result.period, 1L << (scene.levels.size() - 1));
    add_swimmers(scene, layout, result.lattice, settings.delay_correction);
  }
  for (int a = 0; a < 3; ++a) scene.walls[a] = layout.domain.box->walls[a] / scales.velocity();
  require_slow_walls(scene.walls, source);
  scene.body_force = layout.body_force / scales.body_force();
  require_slow_flow(scene, result.lattice.relaxation_time, source);
  require_viscosity(settings.bead_boundary, result.lattice.relaxation_time);
  require_slip(settings.bead_boundary, result.lattice.relaxation_time);
  scene.relaxation_time = result.lattice.relaxation_time;
  for (SwimmerType& type : scene.types) {
    const SwimmerType steady = with_resolved_vibrations(type, 1);
    for (std::size_t k = 0; k < type.bonds.size(); ++k)
      result.damps_springs |= steady.bonds[k].damping != type.bonds[k].damping;
    std::vector<double>& softening = result.softening.emplace_back();
    for (std::size_t k = 0; k < type.angles.size(); ++k) {
      const double with = steady.angles[k].stiffness, without = type.angles[k].stiffness;
      softening.push_back(with < without ? with / without : 1);
    }
    type = steady;
  }
  result.smallest_gap = smallest_gap(placed_beads(layout), layout.domain) / scales.length;
  return result;
}

}  // namespace beadswim
