#include "beadswim/scene/unit_scales.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace beadswim {
namespace {

/// Call visit(name, quantity, unit) for each quantity that has a unit.
void visit_driving(auto& driving, const UnitScales& units, auto&& visit) {
  visit("period", driving.period, units.time);
  const auto visit_amplitudes = [&visit](auto& harmonics, double unit) {
    for (auto& harmonic : harmonics) visit("driving amplitude", harmonic.amplitude, unit);
  };
  for (auto& drive : driving.forces) {
    visit("constant force", drive.constant, units.force());
    visit_amplitudes(drive.harmonics, units.force());
  }
  for (auto& drive : driving.bonds)
    visit_amplitudes(drive.harmonics, drive.quantity == BondQuantity::tension ? units.force() : units.length);
}

void visit_type(auto& type, const UnitScales& units, auto&& visit) {
  for (auto& bead : type.beads) {
    visit("radius", bead.radius, units.length);
    visit("bead density", bead.density, units.density);
    for (auto& coordinate : bead.at) visit("place of a bead", coordinate, units.length);
  }
  for (auto& bond : type.bonds) {
    visit("stiffness", bond.stiffness, units.stiffness());
    visit("rest length", bond.rest_length, units.length);
    visit("damping", bond.damping, units.damping());
  }
  for (auto& angle : type.angles) visit("angular stiffness", angle.stiffness, units.energy());
  visit_driving(type.driving, units, visit);
}

void visit_layout(auto& layout, const UnitScales& units, auto&& visit) {
  const auto visit_components = [&visit](const char* name, auto& quantity, double unit) {
    for (auto&& component : quantity.reshaped()) visit(name, component, unit);
  };
  visit("fluid density", layout.fluid.density, units.density);
  visit("kinematic viscosity", layout.fluid.kinematic_viscosity, units.length * units.velocity());
  visit("thermal energy", layout.fluid.thermal_energy, units.energy());
  if (auto& box = layout.domain.box) {
    visit_components("box length", box->lengths, units.length);
    for (auto& walls : box->walls)
      for (auto* velocity : {&walls.lower, &walls.upper})
        visit_components("wall velocity", *velocity, units.velocity());
  }
  visit_components("flow velocity", layout.flow.velocity, units.velocity());
  visit_components("velocity gradient", layout.flow.velocity_gradient, 1 / units.time);
  visit_components("body force", layout.body_force, units.body_force());
  for (auto& [name, type] : layout.types) visit_type(type, units, visit);
  for (auto& swimmer : layout.swimmers) {
    visit_components("position", swimmer.position, units.length);
    if (swimmer.start)
      for (auto& bead : swimmer.start->positions) visit_components("start position", bead, units.length);
    if (swimmer.driving) visit_driving(*swimmer.driving, units, visit);
  }
}

constexpr auto convert = [](const char*, double& quantity, double unit) { quantity /= unit; };

/// Returns the power of 4 nearest to a number.
double power_of_four(double number) {
  constexpr double max_exponent = 500;
  const double exponent = std::clamp(std::round(std::log2(number) / 2), -max_exponent, max_exponent);
  return std::ldexp(1.0, 2 * static_cast<int>(exponent));
}

bool is_within(double number, double limit) {
  return std::abs(number) <= limit && std::abs(number) >= 1 / limit;
}

}  // namespace

SwimmerType in_units(SwimmerType type, const UnitScales& units) {
  visit_type(type, units, convert);
  return type;
}

Layout in_units(Layout layout, const UnitScales& units) {
  visit_layout(layout, units, convert);
  return layout;
}

UnitScales natural_units(const Layout& layout) {
  const double length = power_of_four(smallest_radius(layout)), time = power_of_four(base_period(layout));
  return {.length = length,
          .time = time,
          .density = power_of_four(layout.fluid.dynamic_viscosity() / length * time / length)};
}

std::string range_fault(const Layout& layout) {
  constexpr double max_base = 1e60, max_derived = 1e250;  // then squares of velocities are finite
  const UnitScales units = natural_units(layout);
  const std::array derived{units.density, units.mass(), units.force(), units.energy(), units.power()};
  if (!is_within(units.length, max_base) || !is_within(units.time, max_base) ||
      !std::ranges::all_of(derived, [](double unit) { return is_within(unit, max_derived); }))
    return fmt::format(
        "with the smallest radius {:.3g}, the period {:.3g} and the dynamic viscosity {:.3g}, results would "
        "exceed the range of floating-point numbers; write the layout in other units",
        smallest_radius(layout), base_period(layout), layout.fluid.dynamic_viscosity());
  // Beyond the first limit, roundoff would exceed the results; below the second, squares would vanish.
  constexpr double max_ratio = 1e15, min_ratio = 1e-60;
  std::string fault;
  visit_layout(layout, units, [&](const char* name, double quantity, double unit) {
    const double ratio = std::abs(quantity / unit);
    const bool is_length = unit == units.length;  // coordinates may be as small as roundoff
    if (ratio <= max_ratio && (ratio >= min_ratio || quantity == 0 || is_length)) return;
    fault = fmt::format(
        "the {} {:.3g} is out of range: in units of the smallest radius {:.3g}, the period {:.3g} and the "
        "dynamic viscosity {:.3g}, numbers must be 0 or between {:g} and {:g}",
        name, quantity, smallest_radius(layout), base_period(layout), layout.fluid.dynamic_viscosity(),
        min_ratio, max_ratio);
  });
  return fault;
}

}  // namespace beadswim
