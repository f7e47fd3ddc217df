#include "swimmer_flags.hpp"

#include <fmt/core.h>
#include <fmt/ranges.h>
#include <cmath>
#include <cstdio>

#include <algorithm>
#include <numbers>

#include "beadswim/core/error.hpp"
#include "beadswim/core/nearest_name.hpp"
#include "beadswim/scene/presets.hpp"
#include "beadswim/scene/units.hpp"
#include "beadswim/tools/program.hpp"

namespace beadswim {
namespace {

/// Parses a flag's value: `count` numbers, or one number that is used for all `count` entries.
std::vector<double> parse_entries(const std::string& text, std::size_t count) {
  const std::vector<double> numbers = parse_numbers(text);
  return numbers.size() == 1 ? std::vector<double>(count, numbers[0]) : numbers;
}

Units::Unit unit_named(Quantity quantity, const std::string& name) {
  if (const Units::Unit* unit = find_known_unit(quantity, name)) return *unit;
  std::vector<std::string> names;
  for (const Units::Unit& unit : known_units(quantity)) names.push_back(unit.name);
  throw InputError("--units", format_unknown_name(name, names));
}

/// Converts the lengths, times and masses of a preset with one type, "a", to units in which its own have
/// these sizes.
void convert(Layout& layout, const UnitSizes& unit) {
  const double force = unit.mass * unit.length / (unit.time * unit.time);
  layout.fluid.density *= unit.mass / std::pow(unit.length, 3);
  layout.fluid.kinematic_viscosity *= unit.length * unit.length / unit.time;
  ThreeBeadSwimmer swimmer = three_beads(layout.types["a"]);
  for (Bead& bead : swimmer.beads) {
    bead.radius *= unit.length;
    bead.density *= unit.mass / std::pow(unit.length, 3);
  }
  for (Spring& spring : swimmer.springs) {
    spring.rest_length *= unit.length;
    spring.stiffness *= force / unit.length;
    spring.damping *= force / unit.length * unit.time;
  }
  swimmer.angular_stiffness *= force * unit.length;
  for (double& amplitude : swimmer.driving.amplitude) amplitude *= force;
  swimmer.driving.period *= unit.time;
  layout.types["a"] = swimmer_type(swimmer);
  if (layout.domain.box) layout.domain.box->lengths *= unit.length;
  for (Swimmer& swimmer_in_box : layout.swimmers) swimmer_in_box.position *= unit.length;
}

}  // namespace

Vec3 parse_vector(const std::string& text) {
  const std::vector<double> numbers = parse_entries(text, 3);
  return Vec3(numbers[0], numbers[1], numbers[2]);
}

void SwimmerFlags::require_complete(const std::vector<std::string>& other_missing_flags) const {
  const std::vector<std::pair<const char*, const std::string*>> needed{
      {"--radius", &radius_},       {"--arm", &arm_},       {"--stiffness", &stiffness_},
      {"--amplitude", &amplitude_}, {"--period", &period_}, {"--viscosity", &fluid_.viscosity()}};
  std::vector<std::string> missing;
  for (const auto& [flag, text] : needed) {
    if (text->empty()) missing.push_back(flag);
  }
  missing.insert(missing.end(), other_missing_flags.begin(), other_missing_flags.end());
  if (missing.empty()) return;
  throw InputError("command line",
                   fmt::format("required flags are missing: {}; give these flags, or start from --preset {}",
                               fmt::join(missing, ", "), presets_.front().name));
}

Layout SwimmerFlags::preset_layout() const {
  std::vector<std::string> names;
  for (const Preset& preset : presets_) {
    if (preset.name == preset_) return preset.layout();
    names.push_back(preset.name);
  }
  throw InputError("--preset", format_unknown_name(preset_, names) +
                                   "; some presets belong to the other command, swimmer or swarm");
}

void SwimmerFlags::apply_beads(ThreeBeadSwimmer& type, double default_density) const {
  if (!radius_.empty()) {
    const auto radii = parse_entries(radius_, 3);
    for (int i = 0; i < 3; ++i) type.beads[i].radius = radii[i];
  }
  for (Bead& bead : type.beads) {
    if (!bead_density_.empty()) bead.density = parse_numbers(bead_density_)[0];
    if (bead.density == 0) bead.density = default_density;
  }
}

void SwimmerFlags::apply_springs(ThreeBeadSwimmer& type) const {
  const auto apply = [&type](const std::string& text, double Spring::*member) {
    if (text.empty()) return;
    const auto values = parse_entries(text, 2);
    for (int i = 0; i < 2; ++i) type.springs[i].*member = values[i];
  };
  apply(arm_, &Spring::rest_length);
  apply(stiffness_, &Spring::stiffness);
  apply(damping_, &Spring::damping);
  type.angular_stiffness =
      angular_stiffness_.empty() ? straightening_stiffness(type) : parse_numbers(angular_stiffness_)[0];
}

void SwimmerFlags::apply_driving(ThreeBeadDriving& driving) const {
  if (!amplitude_.empty()) {
    const auto amplitudes = parse_entries(amplitude_, 2);
    driving.amplitude = {amplitudes[0], amplitudes[1]};
  }
  if (!phase_.empty()) driving.phase = parse_angle(phase_);
  if (std::abs(driving.phase) > 2 * std::numbers::pi && !phase_.ends_with("deg")) {
    fmt::print(
        stderr,
        "beadswim-layout: warning: --phase: {} rad is more than one turn; if the value is in degrees, write "
        "--phase={}deg\n",
        phase_, phase_);
  }
  if (!period_.empty()) driving.period = parse_numbers(period_)[0];
  if (frame_) driving.frame = *frame_;
}

void FluidFlags::apply(Fluid& fluid) const {
  if (!viscosity_.empty()) fluid.kinematic_viscosity = parse_numbers(viscosity_)[0];
  if (!density_.empty()) fluid.density = parse_numbers(density_)[0];
}

Units FluidFlags::units() const {
  if (units_.empty() || units_ == "lattice") return {};
  const std::vector<std::string> names = split_at_commas(units_);
  if (names.size() != 3) {
    throw InputError("--units", fmt::format("\"{}\": the value must be \"lattice\", or the names of the "
                                            "units of length, time and mass, such as um,s,pg",
                                            units_));
  }
  return {.lattice = false,
          .length = unit_named(Quantity::length, names[0]),
          .time = unit_named(Quantity::time, names[1]),
          .mass = unit_named(Quantity::mass, names[2])};
}

UnitSizes SwimmerFlags::preset_units() const {
  const Units units = fluid_.units();
  if (units.lattice) return {};
  const std::vector<double> radii = radius_.empty() ? std::vector<double>{} : parse_numbers(radius_);
  if (radii.size() != 1 || fluid_.viscosity().empty() || fluid_.density().empty())
    throw InputError(
        "--units",
        fmt::format("the preset is in lattice units, and its numbers are converted; give one --radius, "
                    "--viscosity and --density in the units {}, {} and {}, from which the sizes of its "
                    "units follow",
                    units.length.name, units.time.name, units.mass.name));
  const Layout preset = preset_layout();
  Fluid fluid = preset.fluid;
  fluid_.apply(fluid);
  const double length = radii[0] / smallest_radius(preset.types.at("a"));
  return {.length = length,
          .time = preset.fluid.kinematic_viscosity / fluid.kinematic_viscosity * length * length,
          .mass = fluid.density / preset.fluid.density * std::pow(length, 3)};
}

Layout SwimmerFlags::layout(const std::vector<std::string>& other_missing_flags) const {
  if (preset_.empty()) require_complete(other_missing_flags);
  Layout layout = preset_.empty() ? Layout{} : preset_layout();
  layout.units = fluid_.units();
  if (!preset_.empty() && !layout.units.lattice) convert(layout, preset_units());
  fluid_.apply(layout.fluid);
  ThreeBeadSwimmer swimmer = preset_.empty() ? ThreeBeadSwimmer{.driving = {.phase = std::numbers::pi / 2}}
                                             : three_beads(layout.types["a"]);
  apply_beads(swimmer, layout.fluid.density);
  apply_springs(swimmer);
  apply_driving(swimmer.driving);
  const SwimmerType& type = layout.types["a"] = swimmer_type(swimmer);
  if (layout.resolution && layout.units.lattice) layout.resolution = unit_resolution(type, layout.fluid);
  return layout;
}

const std::vector<std::string>& SwimmerFlags::single_values() {
  static const std::vector<std::string> names{
      "radius",    "arm",   "stiffness", "damping", "angular-stiffness", "bead-density",
      "amplitude", "phase", "period",    "frame",   "viscosity",         "density"};
  return names;
}

void SwimmerFlags::apply(Layout& layout, const std::string& source) const {
  const auto equal = [](double a, double b) { return std::abs(a - b) <= 1e-12 * std::abs(b); };
  const SwimmerType& first = layout.types.begin()->second;
  const Resolution unit = unit_resolution(first, layout.fluid);
  const bool has_unit_resolution = layout.resolution &&
                                   equal(layout.resolution->cells_per_radius, unit.cells_per_radius) &&
                                   equal(layout.resolution->relaxation_time, unit.relaxation_time);
  fluid_.apply(layout.fluid);
  for (auto& [name, type] : layout.types) {
    std::optional<ThreeBeadSwimmer> swimmer = three_bead_form(type);
    if (!swimmer)
      throw InputError(
          fmt::format("{}:/types/{}", source, name),
          "this is not a swimmer of three beads on a line, which flags of beadswim-layout swimmer "
          "describe; name what varies by a JSON pointer, such as /types/a/beads/0/radius");
    const double angular = swimmer->angular_stiffness;
    const bool is_default = equal(angular, straightening_stiffness(*swimmer));
    apply_beads(*swimmer, layout.fluid.density);
    apply_springs(*swimmer);
    if (angular_stiffness_.empty() && !is_default) swimmer->angular_stiffness = angular;
    apply_driving(swimmer->driving);
    type = swimmer_type(*swimmer);
  }
  if (has_unit_resolution) layout.resolution = unit_resolution(first, layout.fluid);
}

void PlaceFlags::apply_domain(Domain& domain) const {
  if (unbounded_ || !half_space_.empty()) domain = {};
  if (!half_space_.empty()) {
    if (position_.empty())
      throw InputError("--half-space",
                       "the wall is at the coordinate 0; give the position of the swimmer above it with "
                       "--position");
    domain.half_space = half_space_across(half_space_);
    return;
  }
  std::optional<Box>& box = domain.box;
  if (!box && box_.empty()) {
    if (!boundary_.empty())
      throw InputError("--boundary", "unbounded fluid has no boundary; give the edges of a box with --box");
    return;
  }
  if (!box) box.emplace();
  if (!box_.empty()) box->lengths = parse_vector(box_);
  if (boundary_.empty()) return;
  const std::vector<std::string> names = split_at_commas(boundary_);
  for (int axis = 0; axis < 3; ++axis)
    box->boundary[axis] = from_text<Boundary>(names[names.size() == 1 ? 0 : axis]);
}

void PlaceFlags::apply(Layout& layout) const {
  apply_domain(layout.domain);
  const auto& [name, type] = *layout.types.begin();
  Swimmer swimmer{.id = 0, .type = name};
  if (!axis_.empty()) swimmer.axis = parse_vector(axis_).stableNormalized();
  if (!orientation_.empty()) {
    const std::vector<double> q = parse_numbers(orientation_);
    swimmer.turn = Eigen::Quaterniond(q[0], q[1], q[2], q[3]).normalized();
    swimmer.axis = swimmer.orientation().col(0);
  }
  swimmer.position = position_.empty() ? centred_position(type, swimmer.orientation(), layout.domain.box)
                                       : parse_vector(position_);
  layout.swimmers = {swimmer};
}

}  // namespace beadswim
