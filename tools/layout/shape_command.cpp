#include <fmt/core.h>

#include <algorithm>
#include <concepts>

#include "beadswim/core/error.hpp"
#include "beadswim/core/joined.hpp"
#include "beadswim/documents/layout_document.hpp"
#include "beadswim/scene/gallery.hpp"
#include "beadswim/tools/named_flags.hpp"
#include "beadswim/tools/program.hpp"
#include "commands.hpp"
#include "layout_output.hpp"
#include "swimmer_flags.hpp"

namespace beadswim {
namespace {

void add_direction(CLI::App& command, Vec3& direction) {
  const auto take = [&direction](const std::string& text) {
    direction = parse_vector(text).stableNormalized();
  };
  add_value(command, "--direction", take,
            {"X,Y,Z", number_list({3}, finite()),
             fmt::format("{:g},{:g},{:g}", direction[0], direction[1], direction[2])},
            "Direction of the force in the box, a vector of any length");
}

void add_distance(CLI::App& command, std::optional<double>& arm) {
  begin_group(command, "Springs");
  add_value(command, "--arm", arm, {"L", finite_positive(), "2.5 R"},
            "Distance of neighbouring beads at rest [length]");
}

void add_chain(CLI::App& command, int& beads, int fewest, std::optional<double>& arm) {
  begin_group(command, "Beads");
  add_value(command, "--beads", beads, {"N", whole_number(fewest, max_beads)}, "Number of beads");
  add_distance(command, arm);
}

void add_angular_stiffness(CLI::App& command, std::optional<double>& angular_stiffness,
                           const std::string& initial) {
  begin_group(command, "Springs");
  add_value(command, "--angular-stiffness", angular_stiffness, {"KA", finite_positive(), initial},
            "Stiffness K_A of the angular springs with energy K_A (theta - rest)^2/2 [mass length^2/time^2]");
}

void add_radius(CLI::App& command, GallerySwimmer& swimmer, std::size_t beads) {
  begin_group(command, "Beads");
  const std::string each = beads == 2 ? "R|R1,R2" : beads == 3 ? "R|R1,R2,R3" : "R";
  add_list(
      command, "--radius", swimmer.radius,
      {each, number_list(beads == 1 ? std::vector<std::size_t>{1} : std::vector{1, beads}, finite_positive()),
       "4"},
      beads == 1 ? "Radius of the beads [length]"
                 : "Radius of the beads: one value for all, or one per bead [length]");
}

/// Begins the group of flags of the driving, with a title that states its law.
void begin_driving(CLI::App& command, const std::string& law, GallerySwimmer& swimmer) {
  begin_group(command, "Driving: " + law);
  add_value(command, "--period", swimmer.period, {"T", finite_positive()}, "Period T [time]");
}

void add_arm(CLI::App& command, std::optional<double>& arm) {
  begin_group(command, "Springs");
  add_value(command, "--arm", arm, {"L", finite_positive(), "5 R"}, "Rest length of the bonds [length]");
}

void add_flags(CLI::App& command, Dumbbell& dumbbell) {
  add_radius(command, dumbbell, 2);
  add_arm(command, dumbbell.arm);
  begin_driving(command, "rest length L + A sin(2 pi t/T)", dumbbell);
  add_value(command, "--amplitude", dumbbell.amplitude, {"A", finite_non_negative(), "L/5"},
            "Amplitude A of the rest length [length]");
}

void add_flags(CLI::App& command, Triangle& triangle) {
  add_radius(command, triangle, 3);
  add_arm(command, triangle.arm);
  begin_driving(command, "rest length L + A sin(2 pi t/T - (k - 1) alpha) of side k", triangle);
  add_list(command, "--amplitude", triangle.amplitude,
           {"A|A1,A2,A3", number_list({1, 3}, finite_non_negative()), "L/5"},
           "Amplitudes of the rest lengths [length]");
  add_angle(command, "--phase", triangle.phase, {"ALPHA", angle(), "120deg"},
            "Phase alpha by which a side is behind the previous one, as 1.5 or 90deg [rad]");
}

void add_flags(CLI::App& command, PrescribedThreeBead& swimmer) {
  add_radius(command, swimmer, 3);
  begin_group(command, "Springs");
  add_list(command, "--arm", swimmer.arm, {"L|L1,L2", number_list({1, 2}, finite_positive()), "5 R"},
           "Mean lengths of the arms [length]");
  add_angular_stiffness(command, swimmer.angular_stiffness, "10 k L^2");
  begin_driving(command, "arms L1 + A1 sin(2 pi t/T + alpha), L2 + A2 sin(2 pi t/T)", swimmer);
  add_list(command, "--amplitude", swimmer.amplitude,
           {"A|A1,A2", number_list({1, 2}, finite_non_negative()), "L/5"},
           "Amplitudes A1 and A2 of the arms [length]");
  add_angle(command, "--phase", swimmer.phase, {"ALPHA", angle(), "90deg"},
            "Phase alpha by which arm 1 is ahead of arm 2, as 1.5 or 90deg [rad]");
}

void add_flags(CLI::App& command, PurcellChain& chain) {
  begin_group(command, "Beads");
  add_list(command, "--beads-per-link", chain.beads_per_link,
           {"N|N1,N2", number_list({1, 2}, whole_number(2, max_beads)), "4"},
           "Number of beads of a link, both hinges included, of the outer links and of the middle one");
  add_distance(command, chain.arm);
  add_radius(command, chain, 1);
  add_angular_stiffness(command, chain.angular_stiffness, "1000 gamma omega L^2, L: length of a link");
  begin_driving(command, "hinges at theta + A sin(2 pi t/T), theta + A sin(2 pi t/T + alpha)", chain);
  add_angle(command, "--rest-angle", chain.rest_angle, {"ALPHA", angle(), "60deg"},
            "Mean angle theta of the hinges, 0 for a straight chain, as 1 or 60deg [rad]");
  add_angle(command, "--amplitude", chain.amplitude, {"ALPHA", angle(), "40deg"},
            "Amplitude A of the angles; hinges with A >= theta pass straight [rad]");
  add_angle(command, "--phase", chain.phase, {"ALPHA", angle(), "90deg"},
            "Phase alpha by which hinge 2 is ahead of hinge 1, as 1.5 or 90deg [rad]");
}

void add_flags(CLI::App& command, Flagellum& flagellum) {
  add_chain(command, flagellum.beads, 3, flagellum.arm);
  add_radius(command, flagellum, 1);
  begin_group(command, "Springs");
  add_value(command, "--sperm-number", flagellum.sperm_number, {"S", finite_positive()},
            "Sperm number of the flagellum: its length, divided by the distance that bending travels in a "
            "period [1]");
  add_angular_stiffness(command, flagellum.angular_stiffness, "that of the sperm number");
  command.get_option("--angular-stiffness")->excludes("--sperm-number");
  begin_driving(command, "forces A sin(2 pi t/T) along y on the last bead and the opposite on its neighbour",
                flagellum);
  add_value(command, "--amplitude", flagellum.amplitude,
            {"A", finite_non_negative(), "S K_A/(2 x length), for S < 2 times (S/2)^3"},
            "Amplitude A of the forces [mass length/time^2]");
  add_choice(
      command, "--frame", flagellum.frame,
      "Direction of the forces: y of the box (lab), of the swimmer at time 0 (initial-axis), or of the "
      "swimmer as it turns (body)");
}

void add_flags(CLI::App& command, TowedSphere& sphere) {
  add_radius(command, sphere, 1);
  begin_driving(command, "force F + A sin(2 pi t/T)", sphere);
  add_value(command, "--force", sphere.force, {"F", finite(), "6 pi eta R^2/T"},
            "Constant force F [mass length/time^2]");
  add_value(command, "--amplitude", sphere.amplitude, {"A", finite_non_negative()},
            "Amplitude A of the oscillating force [mass length/time^2]");
  add_direction(command, sphere.direction);
}

void add_flags(CLI::App& command, TowedChain& chain) {
  add_chain(command, chain.beads, 2, chain.arm);
  add_radius(command, chain, 1);
  add_angular_stiffness(command, chain.angular_stiffness, "1000 gamma omega L^2, L: length of the chain");
  begin_driving(command, "constant force F on each bead", chain);
  add_value(command, "--force", chain.force, {"F", finite(), "6 pi eta R^2/T"},
            "Force F on each bead [mass length/time^2]");
  add_direction(command, chain.direction);
}

void add_common_flags(CLI::App& command, GallerySwimmer& swimmer) {
  begin_group(command, "Beads");
  add_value(command, "--bead-density", swimmer.bead_density, {"RHO", finite_positive(), "the fluid's"},
            "Mass density of the beads [mass/length^3]");
}

void add_bond_flags(CLI::App& command, BondedSwimmer& swimmer) {
  begin_group(command, "Springs");
  add_value(command, "--stiffness", swimmer.stiffness,
            {"K", finite_positive(),
             "1000 gamma omega with gamma = 6 pi eta R, omega = 2 pi/T; of a flagellum at least 100 A/L"},
            "Stiffness k of the bonds [mass/time^2]");
  add_value(command, "--damping", swimmer.damping, {"C", finite_non_negative()},
            "Damping c of the dashpots parallel to the bonds [mass/time]");
}

/// Throws InputError if the layout has other units than "lattice" and a flag lacks whose default has a unit.
void require_own_numbers(const CLI::App& kind, const Units& units) {
  if (units.lattice) return;
  std::vector<std::string> missing;
  for (const char* flag : {"--radius", "--period", "--viscosity"}) {
    if (kind.get_option(flag)->empty()) missing.emplace_back(flag);
  }
  if (missing.empty()) return;
  throw InputError(
      "--units",
      "the defaults of other flags are for the units \"lattice\"; give {} in the units {}, {} and {} too",
      joined(missing, ", "), units.length.name, units.time.name, units.mass.name);
}

/// One kind of swimmer. `type` makes its type in a fluid.
struct Kind {
  CLI::App* command = nullptr;
  std::function<SwimmerType(const Fluid&)> type;
  QuantityFlags fluid{};
  std::optional<PlaceFlags> place{};
  bool json_lines = false;
};

using Kinds = std::vector<std::unique_ptr<Kind>>;  // flags refer to the members of a kind

/// Adds the kind of swimmer with these parameters. `examples`: flags of each example in the help.
template <class Parameters>
void add_kind(CLI::App& shape, Kinds& kinds, const std::string& name, const std::string& help,
              const std::vector<std::string>& examples) {
  Kind& kind = *kinds.emplace_back(std::make_unique<Kind>());
  kind.command = shape.add_subcommand(name, help);
  CLI::App& command = *kind.command;
  const auto parameters = std::make_shared<Parameters>();
  add_flags(command, *parameters);
  add_common_flags(command, *parameters);
  if constexpr (std::derived_from<Parameters, BondedSwimmer>) add_bond_flags(command, *parameters);
  kind.type = [parameters](const Fluid& fluid) { return swimmer_type(*parameters, fluid); };
  kind.fluid.add(command, *find_quantity("viscosity"), "1/3");
  kind.fluid.add(command, *find_quantity("density"), "1");
  kind.fluid.add(command, *find_quantity("thermal-energy"), "0");
  kind.fluid.add_units(command);
  kind.place.emplace(command, "the origin of the type's frame", "of the x axis of the type", "periodic");
  kind.place->add_orientation(command);
  begin_group(command, "Output");
  command.add_flag("--jsonl", kind.json_lines, "Write the layout on one line.");
  std::vector<std::string> commands;
  for (const std::string& flags : examples)
    commands.push_back(fmt::format("beadswim-layout shape {} {} >{}.json", name, flags, name));
  set_footer(command, commands, "shapes.md#" + name);
}

/// Returns the kind of the command line.
const Kind& chosen(const Kinds& kinds) {
  return **std::ranges::find_if(kinds, [](const auto& kind) { return kind->command->parsed(); });
}

Layout layout_of(const Kind& kind) {
  Layout layout;
  layout.units = kind.fluid.units();
  require_own_numbers(*kind.command, layout.units);
  layout.fluid = {.density = 1, .kinematic_viscosity = 1.0 / 3};
  kind.fluid.apply(layout.fluid);
  layout.types[kind.command->get_name()] = kind.type(layout.fluid);
  kind.place->apply(layout);
  return layout;
}

}  // namespace

Command add_shape_command(CLI::App& program) {
  CLI::App& shape = *program.add_subcommand(
      "shape",
      "Writes a layout of one swimmer of a kind from the literature. All flags have defaults; without --box "
      "and --half-space, the fluid is unbounded.");
  shape.require_subcommand(1);
  const auto kinds = std::make_shared<Kinds>();
  add_kind<Dumbbell>(shape, *kinds, "dumbbell",
                     "Two beads whose distance oscillates; alone, it does not swim without inertia.",
                     {"--radius 4,2 --unbounded", "--box 60,40,40"});
  add_kind<Triangle>(shape, *kinds, "triangle",
                     "Three beads at the corners of a triangle whose sides oscillate in turn; it rotates.",
                     {"--unbounded", "--phase 90deg --amplitude 4,4,0"});
  add_kind<PrescribedThreeBead>(shape, *kinds, "prescribed-three-bead",
                                "Three beads in a line whose arms have prescribed lengths.",
                                {"--unbounded", "--arm 20,16 --phase 1"});
  add_kind<PurcellChain>(shape, *kinds, "purcell-chain",
                         "Three links of beads with two hinges that oscillate, as a Z.",
                         {"--unbounded", "--beads-per-link 3 --rest-angle 70deg"});
  add_kind<Flagellum>(shape, *kinds, "flagellum", "Elastic chain of beads, swung at its end.",
                      {"--unbounded", "--beads 24 --sperm-number 5"});
  add_kind<TowedSphere>(shape, *kinds, "sphere", "One bead that a constant or oscillating force pulls.",
                        {"--unbounded", "--force 0 --amplitude 0.05 --box 40,40,40 --boundary no-slip"});
  add_kind<TowedChain>(shape, *kinds, "chain",
                       "Elastic chain of beads that equal forces pull, as a fibre that settles.",
                       {"--unbounded", "--beads 20 --direction 1,0,-1"});
  set_footer(shape,
             {"beadswim-layout shape triangle >triangle.json",
              "beadswim-layout shape flagellum --beads 12 | beadswim-layout check"},
             "shapes.md");
  return {.flags = &shape,
          .run =
              [kinds, &program] {
                const Kind& kind = chosen(*kinds);
                write_made_layout(layout_of(kind), program, kind.json_lines ? dump_json_line : dump_json);
              },
          .make = [kinds] { return layout_of(chosen(*kinds)); }};
}

}  // namespace beadswim
