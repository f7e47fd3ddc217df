#include "beadswim/overdamped/memory_setup.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "beadswim/core/bounds.hpp"
#include "beadswim/core/error.hpp"
#include "beadswim/core/setting.hpp"
#include "beadswim/mobility/step_mobility.hpp"

namespace beadswim {
namespace {

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
          fmt::format(
              "a bead of density {:.4g} in fluid of density {:.4g} is too light for the time steps of the "
              "model unsteady; use a density of at least {:.4g}, longer time steps, or {} lbm",
              bead.density, density, density - (density - bead.density) * max_share / share, Setting::model));
    }
  }
}

/// Throws InputError if swimmers are towed, whose flow reaches the images of a cube that replaces open space.
void check_net_forces(const OverdampedScene& scene, const std::string& source) {
  for (const SwimmerType& type : scene.types) {
    if (type.driving.net_force == NetForce::zero) continue;
    throw InputError(
        source, fmt::format("driving forces that do not sum to zero need a box in the model unsteady, which "
                            "replaces open space by a periodic cube; give a box, or use {} rpy",
                            Setting::model));
  }
}

}  // namespace

Box box_for_open_space(const OverdampedScene& scene) {
  constexpr double extents = 5;
  const Bounds bounds(start_positions(scene));
  const double extent = (bounds.high - bounds.low).maxCoeff() + 2 * largest_radius(scene.types);
  return {.lengths = Vec3::Constant(extents * extent), .boundary = {}};
}

FluidMemory fluid_memory(const Layout& layout, const OverdampedScene& scene, bool has_reynolds_stress,
                         const std::string& source) {
  constexpr double per_depth = 0.9;  // spacing divided by penetration depth
  const double smallest = smallest_radius(layout), largest = largest_radius(scene.types);
  const double density = layout.fluid.density;
  // Penetration depth sqrt(2 nu/omega) of the fastest oscillation.
  const double depth =
      std::sqrt(layout.fluid.kinematic_viscosity * shortest_period(layout) / std::numbers::pi);
  if (largest > max_radius_over_depth * depth)
    throw InputError(
        source,
        fmt::format(
            "the radius {:.4g} of a bead is {:.3g} times the penetration depth {:.4g} of the flow, and "
            "the model unsteady treats up to {} times; use a longer period or {} lbm",
            largest, largest / depth, depth, max_radius_over_depth, Setting::model));
  if (largest > max_radius_ratio * smallest)
    throw InputError(
        source, fmt::format("the largest bead radius is {:.3g} times the smallest, and the mesh of the model "
                            "unsteady resolves up to {} times; use {} lbm",
                            largest / smallest, max_radius_ratio, Setting::model));
  check_light_beads(scene, density, source);
  if (!layout.domain.box) check_net_forces(scene, source);
  const double per_radius = max_memory_spacing[scene.moment_order];
  const FluidMemory memory{.density = density,
                           .step = scene.step,
                           .spacing = std::min(per_radius * smallest, per_depth * depth),
                           .has_reynolds_stress = has_reynolds_stress};
  const double points = (mirrored_lengths(scene.box) / memory.spacing).prod();
  if (points > max_mesh_points && !layout.domain.box)
    throw InputError(source,
                     fmt::format("the periodic cube of edge {:.4g} that replaces open space in the model "
                                 "unsteady needs a mesh of {:.2g} points, above the limit of {:.2g}; "
                                 "move the swimmers closer, give a box, or use {} rpy",
                                 scene.box->lengths[0], points, max_mesh_points, Setting::model));
  if (points > max_mesh_points)
    throw InputError(source,
                     fmt::format("the box needs a mesh of {:.2g} points of spacing {:.4g} for the model "
                                 "unsteady, above the limit of {:.2g}; make the box smaller or use {} "
                                 "rpy",
                                 points, memory.spacing, max_mesh_points, Setting::model));
  return memory;
}

}  // namespace beadswim
