#include "beadswim/overdamped/overdamped_setup.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "beadswim/core/error.hpp"
#include "beadswim/core/setting.hpp"
#include "beadswim/core/vec3.hpp"
#include "beadswim/mobility/step_mobility.hpp"
#include "beadswim/overdamped/contacts.hpp"

namespace beadswim {
namespace {

void check_no_slip_walls(const Layout& layout, const std::string& source) {
  for (int a = 0; a < 3 && layout.domain.box; ++a) {
    if (layout.domain.box->boundary[a] != Boundary::no_slip) continue;
    throw InputError(fmt::format("{}:/domain/boundary/{}", source, a),
                     "the boundary is no-slip at both ends of the axis, but mobility models treat only one "
                     "such wall, of a half-space; set the domain to a half-space, make the layout with {} "
                     "periodic or free-slip, or use {} lbm",
                     Setting::boundary, Setting::model);
  }
}

/// Throws InputError if the model unsteady cannot treat the domain or the flow.
void check_unsteady_scene(const Layout& layout, const std::string& source) {
  if (layout.domain.half_space)
    throw InputError(
        source + ":/domain/half_space",
        "the model unsteady lacks no-slip walls; use {} rpy or multipole, or lbm in a box with such walls",
        Setting::model);
  if (!layout.flow.is_zero())
    throw InputError(source + ":/flow", "the model unsteady lacks background flow; use {} rpy or multipole",
                     Setting::model);
}

/// Throws InputError if the model cannot have thermal noise.
void require_model_with_noise(const Layout& layout, MobilityModel model, const std::string& source) {
  const bool is_unsteady = model == MobilityModel::unsteady;
  if (layout.fluid.thermal_energy == 0 || (model != MobilityModel::oseen && !is_unsteady)) return;
  throw InputError(
      source + ":/fluid/thermal_energy",
      is_unsteady ? fmt::format("the model unsteady lacks thermal noise; use {}", models_with_noise(layout))
                  : fmt::format("the mobility of the model oseen is not positive, so that it has no thermal "
                                "noise; use {} rpy",
                                Setting::model));
}

/// Throws InputError if the box is too narrow for the Ewald sum or for contacts between beads and images.
void require_room(const OverdampedScene& scene, const std::string& source) {
  const double largest = largest_radius(scene.types);
  constexpr double radii = 4.4;  // in narrower boxes a bead may touch two images of one bead
  for (int a = 0; a < 3 && scene.domain.box; ++a) {
    if (scene.domain.box->lengths[a] >= radii * largest) continue;
    throw InputError(fmt::format("{}:/domain/lengths/{}", source, a),
                     "the box length {:.6g} is less than {} radii of the largest bead, {:.6g}; enlarge the "
                     "box or use {} lbm",
                     scene.domain.box->lengths[a], radii, radii * largest, Setting::model);
  }
}

/// Returns the number of time steps per base period that contacts need against thermal noise: a step may move
/// a bead by a tenth of the smallest cutoff of contacts d, (2 kT mu h)^(1/2) <= d/10. Returns 0 if no bead
/// can touch another or a wall.
double steps_against_noise(const Layout& layout, const OverdampedScene& scene) {
  const bool is_alone = scene.swimmers.size() == 1 && scene.types[0].beads.size() == 1;
  if (layout.fluid.thermal_energy == 0 || (is_alone && !scene.domain.box && !scene.domain.half_space))
    return 0;
  const double radius = smallest_radius(layout);
  const double d = ContactScale(scene).min_cutoff_per_radius * radius;
  const double diffusion = layout.fluid.thermal_energy * self_mobility(radius, scene.viscosity);
  constexpr double part = 0.1;
  return base_period(layout) * 2 * diffusion / std::pow(part * d, 2);
}

/// Returns the number of time steps per base period. With thermal noise, frames lie on steps.
long steps_in_base_period(const Layout& layout, const OverdampedScene& scene,
                          const MobilitySettings& settings, int frames_per_cycle, const std::string& source) {
  const double period = base_period(layout), shorter = period / std::min(period, shortest_period(layout));
  const auto rounded_up = [&](double steps) {
    const auto whole = static_cast<long>(std::ceil(steps - 1e-9));
    return (whole + frames_per_cycle - 1) / frames_per_cycle * frames_per_cycle;
  };
  const double needed = steps_against_noise(layout, scene);
  constexpr double most = 1e8;
  if (needed > most)
    throw InputError(source,
                     "thermal noise needs {:.2g} time steps in a period, for contacts to hold against it, "
                     "above the limit of {:.0e}; use a shorter period or a lower {}",
                     needed, most, Setting::thermal_energy);
  if (!settings.steps_per_cycle)
    return rounded_up(std::max(MobilitySettings::default_steps_per_cycle * shorter, needed));
  const double steps = *settings.steps_per_cycle * shorter;
  if (steps < needed * (1 - 1e-9))
    throw InputError(Setting::steps_per_cycle,
                     "contacts do not hold against the thermal noise of so long time steps; use at least "
                     "{} {}, or leave it out",
                     static_cast<long>(std::ceil(needed / shorter)), Setting::steps_per_cycle);
  return needed > 0 ? rounded_up(steps) : std::lround(std::ceil(steps - 1e-9));
}

// --- Memory of the fluid (mobility/fluid_memory.hpp): its mesh and limits. Page:
// docs/method/fluid-memory.md.

constexpr double max_radius_over_depth = 1.5, max_radius_ratio = 4, max_mesh_points = 3e8;

/// Throws InputError if the displaced mass of a light bead, of which the fluid takes only the part that the
/// mobility in a step describes, would make the implicit step unstable:
///
///   (m_f - m) 11/(6 h) mu_h < 1/2,   mu_h: self-mobility in the step (step_mobility.hpp)
void check_light_beads(const OverdampedScene& scene, double density, const std::string& source) {
  const double kappa = step_wavenumber(scene.viscosity / density * scene.step);
  for (const SwimmerType& type : scene.types) {
    for (const Bead& bead : type.beads) {
      const double mobility =
          self_mobility(bead.radius, scene.viscosity) * step_self_ratio(kappa * bead.radius);
      const double share = -excess_mass(bead, density) * 11 / (6 * scene.step) * mobility;
      constexpr double max_share = 0.5;
      if (share <= max_share) continue;
      throw InputError(
          source,
          "a bead of density {:.4g} in fluid of density {:.4g} is too light for the time steps of the model "
          "unsteady; use a density of at least {:.4g}, longer time steps, or {} lbm",
          bead.density, density, density - (density - bead.density) * max_share / share, Setting::model);
    }
  }
}

/// Throws InputError if swimmers are towed, whose flow reaches the images of a cube that replaces open space.
void check_net_forces(const OverdampedScene& scene, const std::string& source) {
  for (const SwimmerType& type : scene.types) {
    if (type.driving.net_force == NetForce::zero) continue;
    throw InputError(source,
                     "driving forces that do not sum to zero need a box in the model unsteady, which "
                     "replaces open space by a periodic cube; give a box, or use {} rpy",
                     Setting::model);
  }
}

/// Returns the periodic cube that replaces open space: five times as long as the largest extent of the
/// beads at rest. Its images change the velocity of a lone swimmer by some 0.2 %.
Box box_for_open_space(const OverdampedScene& scene) {
  constexpr double extents = 5;
  const double extent =
      bounding_box(start_positions(scene)).sizes().maxCoeff() + 2 * largest_radius(scene.types);
  return {.lengths = Vec3::Constant(extents * extent), .boundary = {}};
}

/// Returns the memory of the layout's fluid. The mesh resolves the smallest bead and the penetration depth.
/// `scene` has box and time step. `source` is the name of the layout in messages. Throws InputError in these
/// cases:
///   - The largest radius is above 1.5 penetration depths of the fastest oscillation.
///   - The largest radius is more than four times the smallest.
///   - A bead is so light that the time steps would be unstable.
///   - Driving forces in open space do not sum to zero.
///   - The mesh would have more than 3e8 points.
FluidMemory fluid_memory(const Layout& layout, const OverdampedScene& scene, bool has_reynolds_stress,
                         const std::string& source) {
  constexpr double per_depth = 0.9;  // spacing divided by penetration depth
  const double smallest = smallest_radius(layout), largest = largest_radius(scene.types);
  const double density = layout.fluid.density;
  // Penetration depth sqrt(2 nu/omega) of the fastest oscillation.
  const double depth =
      std::sqrt(layout.fluid.kinematic_viscosity * shortest_period(layout) / std::numbers::pi);
  if (largest > max_radius_over_depth * depth)
    throw InputError(source,
                     "the radius {:.4g} of a bead is {:.3g} times the penetration depth {:.4g} of the flow, "
                     "and the model unsteady treats up to {} times; use a longer period or {} lbm",
                     largest, largest / depth, depth, max_radius_over_depth, Setting::model);
  if (largest > max_radius_ratio * smallest)
    throw InputError(source,
                     "the largest bead radius is {:.3g} times the smallest, and the mesh of the model "
                     "unsteady resolves up to {} times; use {} lbm",
                     largest / smallest, max_radius_ratio, Setting::model);
  check_light_beads(scene, density, source);
  if (!layout.domain.box) check_net_forces(scene, source);
  const double per_radius = max_memory_spacing[scene.moment_order];
  const FluidMemory memory{.density = density,
                           .step = scene.step,
                           .spacing = std::min(per_radius * smallest, per_depth * depth),
                           .has_reynolds_stress = has_reynolds_stress};
  const double points = (mirrored_lengths(scene.domain.box) / memory.spacing).prod();
  if (points <= max_mesh_points) return memory;
  throw InputError(
      source,
      layout.domain.box
          ? fmt::format(
                "the box needs a mesh of {:.2g} points of spacing {:.4g} for the model unsteady, above "
                "the limit of {:.2g}; make the box smaller or use {} rpy",
                points, memory.spacing, max_mesh_points, Setting::model)
          : fmt::format(
                "the periodic cube of edge {:.4g} that replaces open space in the model unsteady needs "
                "a mesh of {:.2g} points, above the limit of {:.2g}; move the swimmers closer, give a "
                "box, or use {} rpy",
                scene.domain.box->lengths[0], points, max_mesh_points, Setting::model));
}

/// Returns the scene of a layout, in its units, with this number of time steps per base period. Throws the
/// errors of overdamped_setup().
OverdampedScene scene_of(const Layout& layout, MobilityModel model, const MobilitySettings& settings,
                         int frames_per_cycle, const std::string& source) {
  OverdampedScene scene;
  scene.model = model;
  scene.moment_order = has_moment_order(model) ? settings.multipole_order : 0;
  scene.viscosity = layout.fluid.dynamic_viscosity();
  check_no_slip_walls(layout, source);
  require_model_with_noise(layout, model, source);
  if (model == MobilityModel::unsteady) check_unsteady_scene(layout, source);
  scene.domain = layout.domain;
  scene.flow = layout.flow;
  scene.tolerance = settings.tolerance;
  scene.thermal_energy = layout.fluid.thermal_energy;
  scene.seed = static_cast<std::uint64_t>(settings.seed.value_or(layout.seed.value_or(1)));
  scene.noise_tolerance = settings.noise_tolerance;
  static_cast<Swarm&>(scene) = placed_swimmers(layout);
  if (model == MobilityModel::unsteady && !scene.domain.box) scene.domain.box = box_for_open_space(scene);
  require_room(scene, source);
  const long steps = steps_in_base_period(layout, scene, settings, frames_per_cycle, source);
  scene.step = base_period(layout) / static_cast<double>(steps);
  if (model == MobilityModel::unsteady)
    scene.memory = fluid_memory(layout, scene, settings.reynolds_stress, source);
  return scene;
}

}  // namespace

OverdampedSetup overdamped_setup(const Layout& layout, MobilityModel model, const MobilitySettings& settings,
                                 int frames_per_cycle, const std::string& source) {
  const UnitScales units = natural_units(layout);
  scene_of(layout, model, settings, frames_per_cycle, source);  // errors state numbers in the layout's units
  const Layout natural = in_units(layout, units);
  OverdampedScene scene = scene_of(natural, model, settings, frames_per_cycle, source);
  const long steps = std::lround(base_period(natural) / scene.step);
  return {.scene = std::move(scene),
          .units = units,
          .base_period = base_period(layout),
          .steps_per_cycle = steps};
}

}  // namespace beadswim
