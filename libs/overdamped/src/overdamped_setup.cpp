#include "beadswim/overdamped/overdamped_setup.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "beadswim/core/error.hpp"
#include "beadswim/core/setting.hpp"
#include "beadswim/overdamped/memory_setup.hpp"

namespace beadswim {
namespace {

void check_no_slip_walls(const Layout& layout, const std::string& source) {
  for (int a = 0; a < 3 && layout.domain.box; ++a) {
    if (layout.domain.box->boundary[a] != Boundary::no_slip) continue;
    throw InputError(fmt::format("{}:/domain/boundary/{}", source, a),
                     fmt::format("the boundary is no-slip at both ends of the axis, but mobility models "
                                 "treat only one such wall, of a half-space; set the domain to a half-space, "
                                 "make the layout with {} periodic or free-slip, or use {} lbm",
                                 Setting::boundary, Setting::model));
  }
}

/// Throws InputError if the model unsteady cannot treat the domain or the flow.
void check_unsteady_scene(const Layout& layout, const std::string& source) {
  if (layout.domain.half_space)
    throw InputError(
        source + ":/domain/half_space",
        fmt::format("the model unsteady lacks no-slip walls; use {} rpy or multipole, or lbm in a "
                    "box with such walls",
                    Setting::model));
  if (!layout.flow.is_zero())
    throw InputError(
        source + ":/flow",
        fmt::format("the model unsteady lacks background flow; use {} rpy or multipole", Setting::model));
}

/// Throws InputError if the box is too narrow for the Ewald sum or for contacts between beads and images.
void require_room(const OverdampedScene& scene, const std::string& source) {
  const double largest = largest_radius(scene.types);
  constexpr double radii = 4.4;  // in narrower boxes a bead may touch two images of one bead
  for (int a = 0; a < 3 && scene.box; ++a) {
    if (scene.box->lengths[a] >= radii * largest) continue;
    throw InputError(fmt::format("{}:/domain/lengths/{}", source, a),
                     fmt::format("the box length {:.6g} is less than {} radii of the largest bead, {:.6g}; "
                                 "enlarge the box or use {} lbm",
                                 scene.box->lengths[a], radii, radii * largest, Setting::model));
  }
}

/// Returns the number of time steps per base period.
long steps_in_base_period(const Layout& layout, const MobilitySettings& settings, int frames_per_cycle) {
  const double period = base_period(layout);
  const int per_shortest_period =
      settings.steps_per_cycle.value_or(MobilitySettings::default_steps_per_cycle);
  const long steps =
      std::lround(std::ceil(per_shortest_period * period / std::min(period, shortest_period(layout)) - 1e-9));
  if (settings.steps_per_cycle) return steps;
  return (steps + frames_per_cycle - 1) / frames_per_cycle * frames_per_cycle;
}

/// Converts the scene to these units.
void convert(OverdampedScene& scene, const UnitScales& units) {
  for (SwimmerType& type : scene.types) type = in_units(std::move(type), units);
  for (PlacedSwimmer& swimmer : scene.swimmers) swimmer.position /= units.length;
  scene.viscosity /= units.viscosity();
  if (scene.box) scene.box->lengths /= units.length;
  scene.flow.velocity /= units.velocity();
  scene.flow.velocity_gradient *= units.time;
  scene.step /= units.time;
  if (!scene.memory) return;
  scene.memory->density /= units.density;
  scene.memory->step /= units.time;
  scene.memory->spacing /= units.length;
}

}  // namespace

OverdampedSetup overdamped_setup(const Layout& layout, MobilityModel model, const MobilitySettings& settings,
                                 int frames_per_cycle, const std::string& source) {
  OverdampedSetup setup;
  OverdampedScene& scene = setup.scene;
  scene.model = model;
  scene.moment_order = has_moment_order(model) ? settings.multipole_order : 0;
  scene.viscosity = layout.fluid.dynamic_viscosity();
  check_no_slip_walls(layout, source);
  if (model == MobilityModel::unsteady) check_unsteady_scene(layout, source);
  scene.box = layout.domain.box;
  scene.half_space = layout.domain.half_space;
  scene.flow = layout.flow;
  scene.tolerance = settings.tolerance;
  static_cast<Swarm&>(scene) = placed_swimmers(layout);
  if (model == MobilityModel::unsteady && !scene.box) scene.box = box_for_open_space(scene);
  require_room(scene, source);
  setup.base_period = base_period(layout);
  setup.steps_per_cycle = steps_in_base_period(layout, settings, frames_per_cycle);
  scene.step = setup.base_period / static_cast<double>(setup.steps_per_cycle);
  if (model == MobilityModel::unsteady)
    scene.memory = fluid_memory(layout, scene, settings.reynolds_stress, source);
  setup.units = natural_units(layout);
  convert(scene, setup.units);
  return setup;
}

}  // namespace beadswim
