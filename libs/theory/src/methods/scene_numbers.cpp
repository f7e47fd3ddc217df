#include "beadswim/theory/scene_numbers.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "beadswim/mobility/rotne_prager.hpp"
#include "beadswim/scene/bead_gaps.hpp"
#include "beadswim/swimmers/three_bead_swimmer.hpp"
#include "beadswim/theory/linear_response.hpp"

namespace beadswim {
namespace {

/// Returns the collinear swimmer of a type, with the driving forces along the axis of the swimmer.
CollinearSwimmer along_own_axis(const ThreeBeadSwimmer& type, const Fluid& fluid) {
  return collinear_swimmer(type, Vec3::UnitX(), fluid.dynamic_viscosity());
}

std::array<double, 3> box_over_length(const Box& domain, const ThreeBeadSwimmer& type) {
  const double length =
      type.beads[0].radius + type.springs[0].rest_length + type.springs[1].rest_length + type.beads[2].radius;
  return {domain.lengths[0] / length, domain.lengths[1] / length, domain.lengths[2] / length};
}

TypeNumbers type_numbers(const ThreeBeadSwimmer& type, const Layout& layout) {
  const CollinearSwimmer swimmer = along_own_axis(type, layout.fluid);
  const double nu = layout.fluid.kinematic_viscosity;
  const double omega = swimmer.angular_frequency();
  const std::array<double, 3> speed = bead_speeds(swimmer);

  TypeNumbers numbers;
  numbers.phase = type.driving.phase;
  for (int i = 0; i < 3; ++i) {
    numbers.reynolds = std::max(numbers.reynolds, 2 * type.beads[i].radius * speed[i] / nu);
  }
  numbers.penetration_depth = std::sqrt(2 * nu / omega);
  numbers.radius_over_penetration_depth =
      *std::max_element(swimmer.radius.begin(), swimmer.radius.end()) / numbers.penetration_depth;
  numbers.arm_amplitude = first_order_stroke(swimmer, rotne_prager).amplitude;
  for (int arm = 0; arm < 2; ++arm) {
    const double radius = (swimmer.radius[arm] + swimmer.radius[arm + 1]) / 2;
    const double drag = 6 * std::numbers::pi * swimmer.viscosity * radius;
    numbers.arm_over_radius[arm] = swimmer.arm[arm] / radius;
    numbers.drag_over_spring[arm] = drag * omega / swimmer.stiffness[arm];
    numbers.arm_gap[arm] = swimmer.arm[arm] - 2 * radius;
  }
  if (layout.domain) numbers.box_over_length = box_over_length(*layout.domain, type);
  return numbers;
}

ResolutionNumbers resolution_numbers(const Layout& layout) {
  ResolutionNumbers numbers;
  numbers.cell = smallest_radius(layout) / layout.resolution->cells_per_radius;
  numbers.time_step = (layout.resolution->relaxation_time - 0.5) / 3 * numbers.cell * numbers.cell /
                      layout.fluid.kinematic_viscosity;
  const double sound_speed = numbers.cell / numbers.time_step / std::numbers::sqrt3;
  for (const auto& [name, type] : layout.types) {
    numbers.steps_per_period[name] = type.driving.period / numbers.time_step;
    for (const double speed : bead_speeds(along_own_axis(three_beads(type), layout.fluid))) {
      numbers.mach = std::max(numbers.mach, speed / sound_speed);
    }
  }
  if (layout.domain) numbers.cells_in_box = layout.domain->lengths.prod() / std::pow(numbers.cell, 3);
  return numbers;
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
  for (const auto& [name, type] : layout.types) numbers.types[name] = type_numbers(three_beads(type), layout);
  numbers.smallest_gap = smallest_gap(placed_beads(layout), layout.domain);
  if (layout.resolution) numbers.resolution = resolution_numbers(layout);
  return numbers;
}

}  // namespace beadswim
