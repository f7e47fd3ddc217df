#include "beadswim/theory/scene_numbers.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "beadswim/collinear/rotne_prager.hpp"
#include "beadswim/scene/bead_gaps.hpp"
#include "beadswim/scene/placed_swimmers.hpp"
#include "beadswim/swimmers/swimmer_shape.hpp"
#include "beadswim/theory/linear_response.hpp"

namespace beadswim {
namespace {

/// Returns the box edges, divided by the length of the swimmer along its axis.
std::array<double, 3> box_over_length(const Box& domain, const SwimmerType& type) {
  const double length = reach_of_surfaces(type, 0).length();
  return {domain.lengths[0] / length, domain.lengths[1] / length, domain.lengths[2] / length};
}

TypeNumbers type_numbers(const SwimmerType& type, const Layout& layout) {
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
    numbers.arm_gap.push_back(bond.rest_length - 2 * radius);
  }
  if (layout.domain.box) numbers.box_over_length = box_over_length(*layout.domain.box, type);
  if (const double shear_rate = layout.flow.shear_rate(); shear_rate > 0) {
    numbers.strain_per_period = shear_rate * type.driving.period;
    numbers.shear_reynolds = shear_rate * largest * largest / nu;
  }
  const auto swimmer = collinear_swimmer(type, layout.fluid.dynamic_viscosity());
  if (!swimmer) return numbers;
  const std::array<double, 3> speed = bead_speeds(*swimmer);
  numbers.phase = swimmer->phase;
  numbers.reynolds = 0;
  for (int i = 0; i < 3; ++i)
    numbers.reynolds = std::max(*numbers.reynolds, 2 * type.beads[i].radius * speed[i] / nu);
  const Stroke stroke = first_order_stroke(*swimmer, rotne_prager);
  numbers.arm_amplitude = stroke.amplitude;
  return numbers;
}

ResolutionNumbers resolution_numbers(const Layout& layout) {
  ResolutionNumbers numbers;
  numbers.cell = smallest_radius(layout) / layout.resolution->cells_per_radius;
  numbers.time_step = (layout.resolution->relaxation_time - 0.5) / 3 * numbers.cell * numbers.cell /
                      layout.fluid.kinematic_viscosity;
  const double sound_speed = numbers.cell / numbers.time_step / std::numbers::sqrt3;
  double fastest = 0;
  bool is_known = true;
  for (const auto& [name, type] : layout.types) {
    numbers.steps_per_period[name] = type.driving.period / numbers.time_step;
    const auto swimmer = collinear_swimmer(type, layout.fluid.dynamic_viscosity());
    is_known = is_known && swimmer;
    if (swimmer) fastest = std::max(fastest, std::ranges::max(bead_speeds(*swimmer)));
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

std::array<double, 3> bead_speeds(const CollinearSwimmer& swimmer) {
  const Eigen::Matrix3d mobility = rest_mobility(swimmer, rotne_prager).value;
  const Eigen::Vector3cd force = linear_response(swimmer, mobility).force;
  const Eigen::Vector3cd velocity = mobility.cast<std::complex<double>>() * force;
  return {std::abs(velocity[0]), std::abs(velocity[1]), std::abs(velocity[2])};
}

SceneNumbers scene_numbers(const Layout& layout) {
  SceneNumbers numbers;
  for (const auto& [name, type] : layout.types) numbers.types[name] = type_numbers(type, layout);
  add_start_displacements(layout, numbers.types);
  const std::vector<PlacedBead> beads = placed_beads(layout);
  numbers.smallest_gap = smallest_gap(beads, layout.domain);
  if (const auto& half_space = layout.domain.half_space)
    numbers.smallest_relative_height = smallest_relative_height(beads, *half_space);
  if (layout.resolution) numbers.resolution = resolution_numbers(layout);
  return numbers;
}

}  // namespace beadswim
