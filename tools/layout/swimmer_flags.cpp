#include "swimmer_flags.hpp"

#include <utility>

#include "beadswim/tools/named_flags.hpp"

namespace beadswim {

SwimmerFlags::SwimmerFlags(CLI::App& command, std::vector<Preset> presets, const std::string& preset_help)
    : presets_(std::move(presets)) {
  command.add_option("--preset", preset_, preset_help)->type_name("NAME")->default_str("none");
  add_swimmer(command);
  add_driving(command);
  fluid_.add_to(command);
}

void SwimmerFlags::add_swimmer(CLI::App& command) {
  const auto positive = [](std::vector<std::size_t> counts) {
    return number_list(counts, finite_positive());
  };
  add_absent_flag(command, "--beads,--bead-count,--num-beads,--number-of-beads",
                  "no such flag: a swimmer has three beads and two arms; --radius, --bead-density and --arm "
                  "describe them");
  begin_group(command, "Beads");
  command.add_option("--radius", radius_, "Radius of the beads: one value for all, or one per bead [length]")
      ->type_name("R|R1,R2,R3")
      ->check(positive({1, 3}));
  begin_group(command, "Springs");
  command
      .add_option("--arm", arm_, "Rest length of the springs, between the centres of adjacent beads [length]")
      ->type_name("L|L1,L2")
      ->check(positive({1, 2}));
  command
      .add_option("--stiffness", stiffness_, "Stiffness k of the springs, force per extension [mass/time^2]")
      ->type_name("K|K1,K2")
      ->check(positive({1, 2}));
  command
      .add_option(
          "--damping", damping_,
          "Damping c of the dashpots parallel to the springs, force per rate of extension [mass/time]")
      ->type_name("C|C1,C2")
      ->check(number_list({1, 2}, finite_non_negative()))
      ->default_str("the preset's, else 0");
  command
      .add_option("--angular-stiffness", angular_stiffness_,
                  "Stiffness K_A of the angular spring with energy K_A theta^2/2; theta: angle between the "
                  "arms [mass length^2/time^2]")
      ->type_name("KA")
      ->check(finite_non_negative())
      ->default_str("10 k l^2");
  begin_group(command, "Beads");
  command.add_option("--bead-density", bead_density_, "Mass density of the beads [mass/length^3]")
      ->type_name("RHO")
      ->check(finite_positive())
      ->default_str("the preset's, else the fluid's");
}

void SwimmerFlags::add_driving(CLI::App& command) {
  begin_group(command, "Driving: F1 = A sin(2 pi t/T), F3 = B sin(2 pi t/T + alpha), F2 = -(F1 + F3)");
  command
      .add_option("--amplitude", amplitude_,
                  "Amplitudes A and B of the driving forces on beads 1 and 3 [mass length/time^2]")
      ->type_name("A|A,B")
      ->check(number_list({1, 2}, finite_non_negative()));
  command
      .add_option("--phase", phase_,
                  "Phase alpha by which the force on bead 3 is ahead of that on bead 1, as 1.5 or 90deg; "
                  "negative: --phase=-0.5 [rad]")
      ->type_name("ALPHA")
      ->check(angle())
      ->default_str("the preset's, else pi/2");
  command.add_option("--period", period_, "Period T of the driving forces [time]")
      ->type_name("T")
      ->check(finite_positive());
  add_choice(command, "--frame", frame_,
             "Direction of the driving forces: the x axis (lab), the swimmer's axis at time 0 "
             "(initial-axis), or its arms as they turn (body)")
      ->default_str("lab");
}

void FluidFlags::add_to(CLI::App& command, const std::string& default_viscosity) {
  begin_group(command, "Fluid and box");
  command.add_option("--viscosity", viscosity_, "Kinematic viscosity nu of the fluid [length^2/time]")
      ->type_name("NU")
      ->check(finite_positive())
      ->default_str(default_viscosity);
  command.add_option("--density", density_, "Mass density of the fluid [mass/length^3]")
      ->type_name("RHO")
      ->check(finite_positive())
      ->default_str("1");
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
