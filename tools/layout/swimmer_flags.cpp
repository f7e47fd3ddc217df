#include "swimmer_flags.hpp"

#include <utility>

#include "beadswim/tools/named_flags.hpp"

namespace beadswim {

SwimmerFlags::SwimmerFlags(CLI::App& command, std::vector<Preset> presets, const std::string& preset_help)
    : presets_(std::move(presets)) {
  command
      .add_option("--preset", preset_,
                  "Start from a scene of the paper, and change what other flags give: " + preset_help)
      ->type_name("NAME");
  add_swimmer(command);
  add_driving(command);
  add_fluid(command);
}

void SwimmerFlags::add_swimmer(CLI::App& command) {
  const auto positive = [](std::vector<std::size_t> counts) {
    return number_list(counts, finite_positive());
  };
  command
      .add_option("--radius", radius_,
                  "Radius of the beads, one for all or one each [length]. Default: the preset's.")
      ->type_name("R|R1,R2,R3")
      ->check(positive({1, 3}));
  command
      .add_option("--arm", arm_,
                  "Rest length of the arms, between bead centres [length]. Default: the preset's.")
      ->type_name("L|L1,L2")
      ->check(positive({1, 2}));
  command
      .add_option("--stiffness", stiffness_,
                  "Stiffness k of the arms' springs [mass/time^2]. Default: the preset's.")
      ->type_name("K|K1,K2")
      ->check(positive({1, 2}));
  command
      .add_option("--damping", damping_,
                  "Damping c of the dashpots beside the springs [mass/time]. Default: the preset's, else 0.")
      ->type_name("C|C1,C2")
      ->check(number_list({1, 2}, finite_non_negative()));
  command
      .add_option(
          "--angular-stiffness", angular_stiffness_,
          "K_A of the angular spring U = K_A theta^2/2 that keeps the swimmer straight "
          "[mass length^2/time^2]. Default: 10 k l^2 with the arms' mean k and l, so that an end bead "
          "resists ten times more sideways than along its arm.")
      ->type_name("KA")
      ->check(finite_non_negative());
  command
      .add_option("--bead-density", bead_density_,
                  "Density of the beads [mass/length^3]. Default: the preset's, else the fluid's.")
      ->type_name("RHO")
      ->check(finite_positive());
}

void SwimmerFlags::add_driving(CLI::App& command) {
  command
      .add_option(
          "--amplitude", amplitude_,
          "Amplitudes A and B of the driving forces F1 = A sin(2 pi t/T), F3 = B sin(2 pi t/T + alpha), "
          "F2 = -(F1 + F3); one for both or one each [mass length/time^2]. Default: the preset's.")
      ->type_name("A|A,B")
      ->check(number_list({1, 2}, finite_non_negative()));
  command
      .add_option("--phase", phase_,
                  "Phase alpha [radian]. Default: the preset's, else pi/2. Write --phase=-0.5.")
      ->type_name("ALPHA")
      ->check(finite());
  command.add_option("--period", period_, "Period T [time]. Default: the preset's.")
      ->type_name("T")
      ->check(finite_positive());
  add_choice(command, "--frame", frame_,
             "Direction of the driving forces: lab (along x, an external field), initial-axis (each "
             "swimmer's own axis at the start) or body (along the arms: free of force and torque). "
             "Default: lab.");
}

void SwimmerFlags::add_fluid(CLI::App& command) {
  command
      .add_option("--viscosity", viscosity_,
                  "Kinematic viscosity nu of the fluid [length^2/time]. Default: the preset's.")
      ->type_name("NU")
      ->check(finite_positive());
  command.add_option("--density", density_, "Density of the fluid [mass/length^3]. Default: 1.")
      ->type_name("RHO")
      ->check(finite_positive());
  command
      .add_option(
          "--units", units_,
          "What the numbers are in: lattice, or units of length (m, cm, mm, um, nm), time (s, ms, us, ns) "
          "and mass (kg, g, mg, ug, ng, pg, fg), such as um,s,pg. Default: lattice.")
      ->type_name("lattice|LENGTH,TIME,MASS");
}

PlaceFlags::PlaceFlags(CLI::App& command) {
  auto* const box =
      command.add_option("--box", box_, "Edges of the box, from the origin [length]. Default: the preset's.")
          ->type_name("X,Y,Z")
          ->check(number_list({3}, finite_positive()));
  auto* const boundary =
      command
          .add_option("--boundary", boundary_,
                      "What closes the box, one for all or one each along x, y, z: periodic, free-slip or "
                      "no-slip. Default: the preset's, else periodic.")
          ->type_name("B|BX,BY,BZ")
          ->check(number_list({1, 3}, one_of(all_names<Boundary>())));
  command
      .add_flag("--unbounded", unbounded_,
                "No box: unbounded fluid, for theory and mobility models only (a resolved run needs a box).")
      ->excludes(box)
      ->excludes(boundary);
  command
      .add_option(
          "--position", position_,
          "Centre of bead 2 [length]. Default: the swimmer's middle in the middle of the box; 0,0,0 in "
          "unbounded fluid. Write --position=-1,0,0.")
      ->type_name("X,Y,Z")
      ->check(number_list({3}, finite()));
  command.add_option("--axis", axis_, "Direction from bead 1 to bead 3, of any length. Default: 1,0,0.")
      ->type_name("X,Y,Z")
      ->check(number_list({3}, finite()));
}

}  // namespace beadswim
