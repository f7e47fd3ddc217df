#include "beadswim/theory/scene_numbers.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "beadswim/core/reason_against.hpp"
#include "beadswim/scene/bead_gaps.hpp"
#include "beadswim/scene/placed_swimmers.hpp"
#include "beadswim/swimmers/three_bead_swimmer.hpp"
#include "beadswim/theory/passive_diffusion.hpp"

namespace beadswim {
namespace {

/// Returns the box edges, divided by the length of the swimmer along its axis.
std::array<double, 3> box_over_length(const Box& domain, const SwimmerType& type) {
  const double length = reach_of_surfaces(type, 0).length();
  return {domain.lengths[0] / length, domain.lengths[1] / length, domain.lengths[2] / length};
}

using Motion = std::optional<FirstOrderMotion>;

TypeNumbers type_numbers(const SwimmerType& type, const Motion& motion, const Layout& layout) {
  const double nu = layout.fluid.kinematic_viscosity;
  const double omega = 2 * std::numbers::pi / type.driving.period;
  TypeNumbers numbers;
  const double largest = std::ranges::max(type.beads, {}, &Bead::radius).radius;
  numbers.penetration_depth = std::sqrt(2 * nu / omega);
  numbers.radius_over_penetration_depth = largest / numbers.penetration_depth;
  for (const Bond& bond : type.bonds) {
    const auto [i, j] = bond.beads;
    const double radius = (type.beads[i].radius + type.beads[j].radius) / 2;
    const double drag = 6 * std::numbers::pi * layout.fluid.dynamic_viscosity() * radius;
    numbers.arm_over_radius.push_back(bond.rest_length / radius);
    numbers.drag_over_spring.push_back(drag * omega / bond.stiffness);
    numbers.arm_gaps.push_back(bond.rest_length - 2 * radius);
  }
  if (layout.domain.box) numbers.box_over_swimmer_length = box_over_length(*layout.domain.box, type);
  if (const double shear_rate = layout.flow.shear_rate(); shear_rate > 0) {
    numbers.strain_per_period = shear_rate * type.driving.period;
    numbers.shear_reynolds = shear_rate * largest * largest / nu;
  }
  if (layout.fluid.thermal_energy > 0) {
    for (const Bond& bond : type.bonds)
      numbers.thermal_over_spring.push_back(layout.fluid.thermal_energy /
                                            (bond.stiffness * bond.rest_length * bond.rest_length));
    numbers.momentum_time_over_period = largest * largest / (nu * type.driving.period);
    reason_against([&] {
      const ShapedSwimmer swimmer{type, Eigen::Matrix3d::Identity(), layout.fluid.dynamic_viscosity()};
      const double speed = second_order_motion(swimmer, rotne_prager_tensor).velocity;
      numbers.peclet = peclet_number(type, layout.fluid, speed);
    });
  }
  if (const auto three = three_bead_form(type)) numbers.phase = three->driving.phase;
  if (!motion) return numbers;
  numbers.reynolds_bead = 0;
  for (std::size_t b = 0; b < type.beads.size(); ++b)
    numbers.reynolds_bead =
        std::max(*numbers.reynolds_bead, 2 * type.beads[b].radius * motion->bead_speeds[b] / nu);
  numbers.arm_amplitudes = motion->stroke.amplitude;
  return numbers;
}

ResolutionNumbers resolution_numbers(const std::map<std::string, Motion>& motions, const Layout& layout) {
  ResolutionNumbers numbers;
  numbers.cell = smallest_radius(layout) / layout.resolution->cells_per_radius;
  numbers.time_step = (layout.resolution->relaxation_time - 0.5) / 3 * numbers.cell * numbers.cell /
                      layout.fluid.kinematic_viscosity;
  const double sound_speed = numbers.cell / numbers.time_step / std::numbers::sqrt3;
  double fastest = 0;
  bool is_known = true;
  for (const auto& [name, type] : layout.types) {
    numbers.steps_per_period[name] = type.driving.period / numbers.time_step;
    const Motion& motion = motions.at(name);
    is_known = is_known && motion;
    if (motion) fastest = std::max(fastest, motion->largest_speed());
  }
  if (is_known) numbers.mach = fastest / sound_speed;
  if (layout.domain.box) numbers.cells_in_box = layout.domain.box->lengths.prod() / std::pow(numbers.cell, 3);
  return numbers;
}

/// Adds how far drives at time 0 move beads from their places at rest.
void add_start_displacements(const Layout& layout, std::map<std::string, TypeNumbers>& numbers) {
  const Swarm swarm = listed_swimmers(layout);
  std::vector<double> farthest;  // of each type
  for (const SwimmerType& type : swarm.types) {
    const SwimmerType start = at_start(type);
    farthest.push_back(0);
    for (std::size_t b = 0; b < type.beads.size(); ++b)
      farthest.back() = std::max(farthest.back(), (start.beads[b].at - type.beads[b].at).norm());
  }
  for (std::size_t s = 0; s < layout.swimmers.size(); ++s) {
    if (!has_driven_shape(swarm.type_of(swarm.swimmers[s]).driving)) continue;
    std::optional<double>& largest = numbers[layout.swimmers[s].type].start_displacement;
    largest = std::max(largest.value_or(0), farthest[swarm.swimmers[s].type]);
  }
}

}  // namespace

std::optional<FirstOrderMotion> predicted_motion(const SwimmerType& type, const Fluid& fluid,
                                                 const Eigen::Matrix3d& orientation) {
  std::optional<FirstOrderMotion> motion;
  reason_against([&] {
    motion = first_order_motion({type, orientation, fluid.dynamic_viscosity()}, rotne_prager_tensor);
  });
  return motion;
}

SceneNumbers scene_numbers(const Layout& layout) {
  SceneNumbers numbers;
  std::map<std::string, Motion> motions;
  for (const auto& [name, type] : layout.types) {
    motions[name] = predicted_motion(type, layout.fluid);
    numbers.types[name] = type_numbers(type, motions[name], layout);
  }
  add_start_displacements(layout, numbers.types);
  const std::vector<PlacedBead> beads = placed_beads(layout);
  numbers.smallest_gap = smallest_gap(beads, layout.domain);
  if (const auto& half_space = layout.domain.half_space)
    numbers.smallest_relative_height = smallest_relative_height(beads, *half_space);
  if (layout.resolution) numbers.resolution = resolution_numbers(motions, layout);
  return numbers;
}

}  // namespace beadswim
