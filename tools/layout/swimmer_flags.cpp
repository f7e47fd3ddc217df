#include "swimmer_flags.hpp"

#include <utility>

#include "beadswim/tools/named_flags.hpp"

namespace beadswim {

SwimmerFlags::SwimmerFlags(CLI::App& command, std::vector<Preset> presets, const std::string& preset_help)
    : presets_(std::move(presets)) {
  command.add_option("--preset", preset_, preset_help)->type_name("NAME")->default_str("none");
  add_absent_flag(command, "--beads,--bead-count,--num-beads,--number-of-beads",
                  "no such flag: a swimmer has three beads and two arms; --radius, --bead-density and --arm "
                  "describe them");
  for (const NamedQuantity& quantity : named_quantities())
    quantities_.add(command, quantity, quantity.initial);
  quantities_.add_units(command);
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
  command.add_option_function<std::string>(flag, take, quantity.help)
      ->type_name(quantity.symbols)
      ->check(quantity.count == 1 ? each : number_list({1, quantity.count}, each))
      ->default_str(initial);
}

void QuantityFlags::add_units(CLI::App& command) {
  begin_group(command, "Fluid and box");
  command
      .add_option("--units", units_,
                  "Units of the layout: lattice, or units of length (m to nm), time (s to ns) and mass (kg "
                  "to fg), such as um,s,pg; a preset is converted to them")
      ->type_name("lattice|LENGTH,TIME,MASS")
      ->default_str("lattice");
}

PlaceFlags::PlaceFlags(CLI::App& command, const std::string& origin, const std::string& axis,
                       const std::string& default_boundary) {
  begin_group(command, "Fluid and box");
  auto* const box =
      command
          .add_option("--box", box_,
                      "Edge lengths of the box of fluid, one corner of which is the origin [length]")
          ->type_name("X,Y,Z")
          ->check(number_list({3}, finite_positive()));
  auto* const boundary = command
                             .add_option("--boundary", boundary_,
                                         "Boundary conditions of the box, one value for all axes or one per "
                                         "axis: periodic, free-slip or no-slip")
                             ->type_name("B|BX,BY,BZ")
                             ->check(number_list({1, 3}, one_of(all_names<Boundary>())))
                             ->default_str(default_boundary);
  auto* const unbounded =
      command
          .add_flag("--unbounded", unbounded_,
                    "Use unbounded fluid instead of a box. Only theory and mobility models can treat it, not "
                    "the lattice.")
          ->excludes(box)
          ->excludes(boundary);
  command
      .add_option("--half-space", half_space_,
                  "Use fluid over a plane no-slip wall instead of a box, where this coordinate is above 0. "
                  "Only theory and mobility models can treat it, not the lattice. Needs --position.")
      ->type_name("x|y|z")
      ->check(one_of({"x", "y", "z"}))
      ->excludes(box)
      ->excludes(boundary)
      ->excludes(unbounded);
  begin_group(command, "Placement");
  command
      .add_option("--position", position_,
                  "Position of " + origin + "; write negative values as --position=-1,0,0 [length]")
      ->type_name("X,Y,Z")
      ->check(number_list({3}, finite()))
      ->default_str("the swimmer at the centre of the box");
  command.add_option("--axis", axis_, "Direction " + axis + ", a vector of any length")
      ->type_name("X,Y,Z")
      ->check(number_list({3}, finite()))
      ->default_str("1,0,0");
}

void PlaceFlags::add_orientation(CLI::App& command) {
  command
      .add_option("--orientation", orientation_,
                  "Rotation from the frame of the type to the box, instead of --axis: a quaternion of any "
                  "length")
      ->type_name("W,X,Y,Z")
      ->check(number_list({4}, finite()))
      ->excludes("--axis");
}

}  // namespace beadswim
