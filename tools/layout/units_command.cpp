#include <cmath>
#include <map>

#include "beadswim/core/error.hpp"
#include "beadswim/scene/unit_scales.hpp"
#include "beadswim/scene/units.hpp"
#include "beadswim/tools/named_flags.hpp"
#include "commands.hpp"
#include "layout_output.hpp"
#include "swimmer_flags.hpp"

namespace beadswim {
namespace {

/// A size with the name of its unit, such as 0.25um; without a name in the units of length and time that the
/// flags or the layout name.
struct Size {
  double number = 1;
  const Units::Unit* unit = nullptr;

  double in(const Units::Unit& other) const {
    return unit ? number * unit->si_factor / other.si_factor : number;
  }
};

struct UnitsFlags {
  std::vector<std::string> files{"-"};
  std::string to, cell, step;
  std::optional<double> viscosity, density;
};

Size parse_size(const std::string& text, Quantity quantity, const std::string& flag) {
  const std::size_t end = text.find_last_of("0123456789.") + 1;
  Size size;
  if (!finite_positive()(text.substr(0, end)).empty())
    throw InputError(
        flag, "\"{}\": the value must be a number greater than 0, which the name of a unit may follow", text);
  size.number = parse_numbers(text.substr(0, end)).front();
  if (end < text.size()) size.unit = &unit_named(quantity, text.substr(end), flag);
  return size;
}

/// Throws InputError if the flags that this conversion needs are not exactly those that are given.
void require_flags(const UnitsFlags& flags, const std::string& conversion, bool viscosity, bool step,
                   bool scales) {
  const auto require = [&](const char* flag, bool is_given, bool is_needed) {
    if (is_given == is_needed) return;
    throw InputError(flag, "{} {} this flag; {}", conversion, is_needed ? "needs" : "does not use",
                     is_needed ? "give it" : "leave it out");
  };
  require("--cell", !flags.cell.empty(), scales);
  require("--step", !flags.step.empty(), step);
  require("--viscosity", flags.viscosity.has_value(), viscosity);
  if (!scales || viscosity) require("--density", flags.density.has_value(), viscosity);
}

/// Returns the new units in the units of the layout.
UnitScales scales_between(const Layout& layout, const Units& to, const UnitsFlags& flags) {
  const Units& from = layout.units;
  const Fluid& fluid = layout.fluid;
  if (from.lattice && to.lattice)
    throw InputError("--to", "the layout is in lattice units already; name other units, such as um,s,pg");
  if (from.lattice) {
    require_flags(flags, "conversion from lattice units", true, false, true);
    const double cell = parse_size(flags.cell, Quantity::length, "--cell").in(to.length);
    return {.length = 1 / cell,
            .time = *flags.viscosity / (fluid.kinematic_viscosity * cell * cell),
            .density = fluid.density / *flags.density};
  }
  if (to.lattice) {
    require_flags(flags, "conversion to lattice units", false, true, true);
    return {.length = parse_size(flags.cell, Quantity::length, "--cell").in(from.length),
            .time = parse_size(flags.step, Quantity::time, "--step").in(from.time),
            .density = fluid.density / flags.density.value_or(1)};
  }
  require_flags(flags, "conversion between units with names", false, false, false);
  const double length = to.length.si_factor / from.length.si_factor;
  return {.length = length,
          .time = to.time.si_factor / from.time.si_factor,
          .density = to.mass.si_factor / from.mass.si_factor / std::pow(length, 3)};
}

/// Returns the size of the unit of a named quantity; nullopt if it is not known.
std::optional<double> unit_of(const std::string& name, const UnitScales& units) {
  const std::map<std::string, double> sizes{{"radius", units.length},
                                            {"arm", units.length},
                                            {"stiffness", units.stiffness()},
                                            {"damping", units.damping()},
                                            {"angular-stiffness", units.energy()},
                                            {"bead-density", units.density},
                                            {"amplitude", units.force()},
                                            {"phase", 1},
                                            {"period", units.time},
                                            {"viscosity", units.length * units.velocity()},
                                            {"density", units.density}};
  const auto found = sizes.find(name);
  return found == sizes.end() ? std::nullopt : std::optional(found->second);
}

/// Converts the values of a study. `layout`: the converted layout, to which JSON pointers lead. Removes
/// values whose units are not known.
void convert_study(Json& study, const Json& layout, const UnitScales& units) {
  Json converted = Json::object();
  for (const auto& [name, value] : study.items()) {
    if (value.is_string()) {
      converted[name] = value;
    } else if (name.starts_with('/')) {
      const Json::json_pointer place(name);
      if (layout.contains(place) && layout[place].is_number()) converted[name] = layout[place];
    } else if (const auto unit = unit_of(name, units)) {
      converted[name] = value.get<double>() / *unit;
    }
  }
  study = converted.empty() ? Json() : converted;
}

void convert_layouts(const UnitsFlags& flags, const CLI::App& program) {
  const Units to = parse_units(flags.to, "--to");
  filter_layouts(flags.files, program, FilterOutput::like_input,
                 [&](const StreamMember&, LayoutDocument document, const auto& emit) {
                   const UnitScales scales = scales_between(document.layout, to, flags);
                   document.layout = in_units(document.layout, scales);
                   document.layout.units = to;
                   require_sound(document.layout, "the new units");
                   if (!document.study.is_null())
                     convert_study(document.study, layout_to_json(document), scales);
                   emit(document);
                 });
}

}  // namespace

Command add_units_command(CLI::App& program) {
  const auto flags = std::make_shared<UnitsFlags>();
  CLI::App* const command = program.add_subcommand("units", "Writes the same scene in other units.");
  add_layout_files(*command, flags->files);
  add_value(*command, "--to", flags->to, {.name = "lattice|LENGTH,TIME,MASS"},
            "Units of the new layout: lattice, or names such as um,s,pg")
      ->required();
  add_value(*command, "--cell", flags->cell, {.name = "L"},
            "From or to lattice units: size of their unit of length, such as 0.25um; without the name of a "
            "unit, in the new or old unit of length [length]");
  add_value(*command, "--step", flags->step, {.name = "T"},
            "To lattice units: size of their unit of time, such as 20ns [time]");
  add_value(*command, "--viscosity", flags->viscosity, {"NU", finite_positive()},
            "From lattice units: kinematic viscosity of the fluid in the new units [length^2/time]");
  add_value(*command, "--density", flags->density,
            {"RHO", finite_positive(), "needed from, 1 to lattice units"},
            "From or to lattice units: density of the fluid in the new units [mass/length^3]");
  set_footer(
      *command,
      {"beadswim-layout units layout.json --to um,us,pg --cell 0.25um --viscosity 1 --density 1 >water.json",
       "beadswim-layout units water.json --to lattice --cell 0.25um --step 20ns >lattice.json"},
      "units.md");
  return {command, [flags, &program] { convert_layouts(*flags, program); }};
}

}  // namespace beadswim
