#include "swimmer_flags.hpp"

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <cmath>
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

void warn_of_turns(const std::string& phase) {
  if (std::abs(parse_angle(phase)) <= 2 * std::numbers::pi || phase.ends_with("deg")) return;
  print_to_stderr(
      fmt::format("beadswim-layout: warning: --phase: {} rad is more than one turn; if the value is in "
                  "degrees, write --phase={}deg\n",
                  phase, phase));
}

void SwimmerFlags::require_complete(const std::vector<std::string>& other_missing_flags) const {
  std::vector<std::string> missing;
  for (const NamedQuantity& quantity : named_quantities())
    if (quantity.initial.empty() && !quantities_.values().contains(quantity.name))
      missing.push_back("--" + quantity.name);
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

void QuantityFlags::apply(Fluid& fluid) const {
  SwimmerParameters parameters{.fluid = fluid};
  set_quantities(parameters, values_);
  fluid = parameters.fluid;
}

Units QuantityFlags::units() const {
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
  const Units units = quantities_.units();
  if (units.lattice) return {};
  const QuantityValues& values = quantities_.values();
  const auto radii = values.find("radius");
  if (radii == values.end() || radii->second.size() != 1 || !values.contains("viscosity") ||
      !values.contains("density"))
    throw InputError(
        "--units",
        fmt::format("the preset is in lattice units, and its numbers are converted; give one --radius, "
                    "--viscosity and --density in the units {}, {} and {}, from which the sizes of its "
                    "units follow",
                    units.length.name, units.time.name, units.mass.name));
  const Layout preset = preset_layout();
  Fluid fluid = preset.fluid;
  quantities_.apply(fluid);
  const double length = radii->second[0].get<double>() / smallest_radius(preset.types.at("a"));
  return {.length = length,
          .time = preset.fluid.kinematic_viscosity / fluid.kinematic_viscosity * length * length,
          .mass = fluid.density / preset.fluid.density * std::pow(length, 3)};
}

Layout SwimmerFlags::layout(const std::vector<std::string>& other_missing_flags) const {
  if (preset_.empty()) require_complete(other_missing_flags);
  Layout layout = preset_.empty() ? Layout{} : preset_layout();
  layout.units = quantities_.units();
  if (!preset_.empty() && !layout.units.lattice) convert(layout, preset_units());
  SwimmerParameters parameters{.swimmer = {.driving = {.phase = std::numbers::pi / 2}},
                               .fluid = layout.fluid};
  if (!preset_.empty()) parameters.swimmer = three_beads(layout.types["a"]);
  set_quantities(parameters, quantities_.values());
  ThreeBeadSwimmer& swimmer = parameters.swimmer;
  for (Bead& bead : swimmer.beads)
    if (bead.density == 0) bead.density = parameters.fluid.density;
  if (!quantities_.values().contains("angular-stiffness"))
    swimmer.angular_stiffness = straightening_stiffness(swimmer);
  layout.fluid = parameters.fluid;
  const SwimmerType& type = layout.types["a"] = swimmer_type(swimmer);
  if (layout.resolution && layout.units.lattice) layout.resolution = unit_resolution(type, layout.fluid);
  return layout;
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
