#include "swimmer_flags.hpp"

#include <fmt/core.h>

#include <cmath>
#include <numbers>

#include "beadswim/core/names.hpp"
#include "beadswim/scene/presets.hpp"
#include "beadswim/scene/units.hpp"
#include "beadswim/tools/named_flags.hpp"

namespace beadswim {
const Units::Unit& unit_named(Quantity quantity, const std::string& name, const std::string& flag) {
  if (const Units::Unit* unit = find_known_unit(quantity, name)) return *unit;
  std::vector<std::string> names;
  for (const Units::Unit& unit : known_units(quantity)) names.push_back(unit.name);
  throw InputError(flag, format_unknown_name(name, names));
}

Units parse_units(const std::string& text, const std::string& flag) {
  if (text.empty() || text == "lattice") return {};
  const std::vector<std::string> names = split_at_commas(text);
  if (names.size() != 3) {
    throw InputError(flag,
                     "\"{}\": the value must be \"lattice\", or the names of the units of length, time and "
                     "mass, such as um,s,pg",
                     text);
  }
  return {.lattice = false,
          .length = unit_named(Quantity::length, names[0], flag),
          .time = unit_named(Quantity::time, names[1], flag),
          .mass = unit_named(Quantity::mass, names[2], flag)};
}

Vec3 parse_vector(const std::string& text) {
  const std::vector<double> numbers = parse_numbers(text);
  return numbers.size() == 1 ? Vec3(Vec3::Constant(numbers[0])) : Vec3(numbers[0], numbers[1], numbers[2]);
}

void warn_of_turns(const std::string& phase) {
  if (std::abs(parse_angle(phase)) <= 2 * std::numbers::pi || phase.ends_with("deg")) return;
  print_to_stderr(
      fmt::format("beadswim-layout: warning: --phase: {} rad is more than one turn; if the value is in "
                  "degrees, write --phase={}deg\n",
                  phase, phase));
}

void QuantityFlags::add(CLI::App& command, const NamedQuantity& quantity, const std::string& initial) {
  begin_group(command, quantity.group);
  const std::string flag = "--" + quantity.name;
  if (quantity.range == QuantityRange::frame) {
    add_word(command, flag, all_names<DrivingFrame>(), initial, quantity.help,
             [this, &quantity](const std::string& word) { values_[quantity.name] = word; });
    return;
  }
  const bool is_angle = quantity.range == QuantityRange::angle;
  const CLI::Validator each = is_angle                                    ? angle()
                              : quantity.range == QuantityRange::positive ? finite_positive()
                                                                          : finite_non_negative();
  const auto take = [this, &quantity, is_angle](const std::string& text) {
    if (is_angle) warn_of_turns(text);
    values_[quantity.name] = is_angle ? Json(parse_angle(text)) : Json(parse_numbers(text));
  };
  const CLI::Validator all = quantity.count == 1 ? each : number_list({1, quantity.count}, each);
  add_value(command, flag, take, {quantity.symbols, all, initial}, quantity.help);
}

void QuantityFlags::add_units(CLI::App& command) {
  begin_group(command, "Fluid and box");
  add_value(command, "--units", units_, {.name = "lattice|LENGTH,TIME,MASS", .initial = "lattice"},
            "Units of the layout: lattice, or units of length (m to nm), time (s to ns) and mass (kg to fg), "
            "such as um,s,pg; a preset is converted to them");
  const CLI::Validator kelvin(
      [](const std::string& text) {
        const bool is_kelvin =
            text.ends_with('K') && finite_non_negative()(text.substr(0, text.size() - 1)).empty();
        return is_kelvin
                   ? ""
                   : fmt::format("\"{}\": the value must be a temperature in kelvin, such as 300K", text);
      },
      "");
  add_value(
      command, "--temperature", temperature_, {"TK", kelvin},
      "Temperature of the fluid in kelvin, such as 300K, instead of --thermal-energy; with --units in SI")
      ->excludes(command.get_option("--thermal-energy"));
}

QuantityValues QuantityFlags::values() const {
  if (temperature_.empty()) return values_;
  constexpr double boltzmann = 1.380649e-23;  // [J/K]
  const Units units = this->units();
  if (units.lattice)
    throw InputError("--temperature",
                     "units \"lattice\" have no kelvin; give --units, such as um,s,pg, or --thermal-energy");
  QuantityValues values = values_;
  const double energy = units.mass.si_factor * std::pow(units.length.si_factor / units.time.si_factor, 2);
  const double kelvins = parse_numbers(temperature_.substr(0, temperature_.size() - 1))[0];
  values["thermal-energy"] = Json::array({boltzmann * kelvins / energy});
  return values;
}

void QuantityFlags::apply(Fluid& fluid) const {
  SwimmerParameters parameters{.fluid = fluid};
  set_quantities(parameters, values());
  fluid = parameters.fluid;
}

PlaceFlags::PlaceFlags(CLI::App& command, const std::string& origin, const std::string& axis,
                       const std::string& default_boundary) {
  begin_group(command, "Fluid and box");
  auto* const box = add_value(command, "--box", box_, {"X,Y,Z", number_list({3}, finite_positive())},
                              "Edge lengths of the box of fluid, one corner of which is the origin [length]");
  auto* const boundary =
      add_value(command, "--boundary", boundary_,
                {"B|BX,BY,BZ", number_list({1, 3}, one_of(all_names<Boundary>())), default_boundary},
                "Boundary conditions of the box, one value for all axes or one per axis: periodic, free-slip "
                "or no-slip");
  auto* const unbounded =
      command
          .add_flag("--unbounded", unbounded_,
                    "Use unbounded fluid instead of a box. Only theory and mobility models can treat it, not "
                    "the lattice.")
          ->excludes(box)
          ->excludes(boundary);
  add_value(command, "--half-space", half_space_, {"x|y|z", one_of({"x", "y", "z"})},
            "Use fluid over a plane no-slip wall instead of a box, where this coordinate is above 0. Only "
            "theory and mobility models can treat it, not the lattice. Needs --position.")
      ->excludes(box)
      ->excludes(boundary)
      ->excludes(unbounded);
  begin_group(command, "Placement");
  add_value(command, "--position", position_,
            {"X,Y,Z", number_list({3}, finite()), "the swimmer at the centre of the box"},
            "Position of " + origin + "; write negative values as --position=-1,0,0 [length]");
  add_value(command, "--axis", axis_, {"X,Y,Z", number_list({3}, finite()), "1,0,0"},
            "Direction " + axis + ", a vector of any length");
}

void PlaceFlags::add_orientation(CLI::App& command) {
  add_value(command, "--orientation", orientation_, {"W,X,Y,Z", number_list({4}, finite())},
            "Rotation from the frame of the type to the box, instead of --axis: a quaternion of any length")
      ->excludes("--axis");
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
