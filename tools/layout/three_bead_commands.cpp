#include <cmath>
#include <numbers>
#include <utility>

#include "beadswim/core/joined.hpp"
#include "beadswim/core/names.hpp"
#include "beadswim/scene/presets.hpp"
#include "beadswim/scene/swarm.hpp"
#include "beadswim/tools/named_flags.hpp"
#include "commands.hpp"
#include "layout_output.hpp"
#include "swimmer_flags.hpp"

// The commands swimmer and swarm: layouts of the paper's three-bead swimmer (Pickl et al. 2017).

namespace beadswim {
namespace {

/// A named scene of the paper (Pickl et al. 2017). Its values are used for flags that are not given.
struct Preset {
  std::string name;
  Layout (*layout)() = nullptr;
};

/// Sizes of the units of length, time and mass of a preset, in the units of the flag --units.
struct UnitSizes {
  double length = 1, time = 1, mass = 1;
};

/// Converts the lengths, times and masses of a preset with one type, "a", to units in which its own have
/// these sizes, except those that flags must give: of the fluid, and radii.
void convert(Layout& layout, const UnitSizes& unit) {
  const double force = unit.mass * unit.length / (unit.time * unit.time);
  ThreeBeadSwimmer swimmer = three_beads(layout.types["a"]);
  for (Bead& bead : swimmer.beads) bead.density *= unit.mass / std::pow(unit.length, 3);
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

/// Flags that describe a swimmer type and its fluid.
class SwimmerFlags {
 public:
  /// Adds the flags to the command. `preset_help`: description of the presets, for the help.
  SwimmerFlags(CLI::App& command, std::vector<Preset> presets, const std::string& preset_help)
      : presets_(std::move(presets)) {
    add_value(command, "--preset", preset_, {.name = "NAME", .initial = "none"}, preset_help);
    add_absent_flag(
        command, "--beads,--bead-count,--num-beads,--number-of-beads",
        "no such flag: a swimmer has three beads and two arms; --radius, --bead-density and --arm "
        "describe them");
    for (const NamedQuantity& quantity : named_quantities())
      quantities_.add(command, quantity, quantity.initial);
    quantities_.add_units(command);
  }

  /// Returns the layout that the flags describe. It has one type, "a". Flags that are not given have the
  /// values of the preset, converted to the units of the flag --units. Without a preset, throws InputError if
  /// required flags are missing; the message lists these flags and `other_missing_flags`.
  Layout layout(const std::vector<std::string>& other_missing_flags) const {
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

  const std::string& preset() const { return preset_; }  ///< name of the preset; empty if none is given
  /// Returns the sizes of the units of the preset. They follow from the bead radius, the viscosity and the
  /// density of the flags. Throws InputError if one of these is missing.
  UnitSizes preset_units() const {
    const Units units = quantities_.units();
    if (units.lattice) return {};
    const QuantityValues values = quantities_.values();
    const auto radii = values.find("radius");
    if (radii == values.end() || radii->second.size() != 1 || !values.contains("viscosity") ||
        !values.contains("density"))
      throw InputError(
          "--units",
          "the preset is in lattice units, and its numbers are converted; give one --radius, --viscosity and "
          "--density in the units {}, {} and {}, from which the sizes of its units follow",
          units.length.name, units.time.name, units.mass.name);
    const Layout preset = preset_layout();
    Fluid fluid = preset.fluid;
    quantities_.apply(fluid);
    const double length = radii->second[0].get<double>() / smallest_radius(preset.types.at("a"));
    return {.length = length,
            .time = preset.fluid.kinematic_viscosity / fluid.kinematic_viscosity * length * length,
            .mass = fluid.density / preset.fluid.density * std::pow(length, 3)};
  }

 private:
  void require_complete(const std::vector<std::string>& other_missing_flags) const {
    std::vector<std::string> missing;
    for (const NamedQuantity& quantity : named_quantities())
      if (quantity.initial.empty() && !quantities_.values().contains(quantity.name))
        missing.push_back("--" + quantity.name);
    missing.insert(missing.end(), other_missing_flags.begin(), other_missing_flags.end());
    if (missing.empty()) return;
    throw InputError("command line",
                     "required flags are missing: {}; give these flags, or start from --preset {}",
                     joined(missing, ", "), presets_.front().name);
  }

  Layout preset_layout() const {
    std::vector<std::string> names;
    for (const Preset& preset : presets_) {
      if (preset.name == preset_) return preset.layout();
      names.push_back(preset.name);
    }
    throw InputError("--preset", format_unknown_name(preset_, names) +
                                     "; some presets belong to the other command, swimmer or swarm");
  }

  std::vector<Preset> presets_;
  std::string preset_;
  QuantityFlags quantities_;
};

struct OneSwimmerFlags {
  explicit OneSwimmerFlags(CLI::App& command)
      : swimmer(command, {{"paper-single", paper_single}},
                "Scene that replaces missing flags: paper-single (single swimmer of Pickl et al. 2017). "
                "Without it, flags without a default are required"),
        place(command, "bead 2, the middle bead", "from bead 1 to bead 3", "the preset's, else periodic") {}

  SwimmerFlags swimmer;
  PlaceFlags place;
  bool json_lines = false;
};

Layout layout_of(const OneSwimmerFlags& flags) {
  std::vector<std::string> other_missing_flags;
  if (!flags.place.defines_domain()) other_missing_flags = {"--box, --unbounded or --half-space"};
  Layout layout = flags.swimmer.layout(other_missing_flags);
  flags.place.apply(layout);
  return layout;
}

constexpr double max_swimmers = 1e6;

Index3 index_of(const std::string& text) {
  return parse_vector(text).array().cast<int>();
}

struct SwarmFlags {
  explicit SwarmFlags(CLI::App& command)
      : swimmer(command, {{"paper-uniform", paper_swarm}, {"paper-defect", paper_swarm}},
                "Swarm of Pickl et al. 2017 that replaces missing flags: paper-uniform (all gaps 32) or "
                "paper-defect (core gap 37, block gaps 56,46,46)") {}

  SwimmerFlags swimmer;
  std::string block_swimmers, blocks, core_gap, block_gap;
};

SwarmPlan plan_of(const SwarmFlags& flags) {
  SwarmPlan plan;
  if (flags.swimmer.preset() == "paper-uniform") plan = paper_uniform_plan();
  if (flags.swimmer.preset() == "paper-defect") plan = paper_defect_plan();
  if (!flags.swimmer.preset().empty()) {
    const double unit = flags.swimmer.preset_units().length;
    plan.core_gap *= unit;
    plan.block_gap *= unit;
  }
  if (!flags.block_swimmers.empty()) plan.block_swimmers = index_of(flags.block_swimmers);
  if (!flags.blocks.empty()) plan.blocks = index_of(flags.blocks);
  if (!flags.core_gap.empty()) plan.core_gap = parse_vector(flags.core_gap);
  if (!flags.block_gap.empty()) plan.block_gap = parse_vector(flags.block_gap);
  const double swimmers = plan.block_swimmers.cast<double>().prod() * plan.blocks.cast<double>().prod();
  if (swimmers > max_swimmers) {
    throw InputError(
        "--blocks",
        "the blocks have {:g} swimmers in total, but at most {:g} are possible; use fewer or smaller blocks",
        swimmers, max_swimmers);
  }
  return plan;
}

Layout layout_of(const SwarmFlags& flags) {
  std::vector<std::string> other_missing_flags;
  if (flags.core_gap.empty()) other_missing_flags.emplace_back("--core-gap");
  if (flags.block_gap.empty()) other_missing_flags.emplace_back("--block-gap");
  Layout layout = flags.swimmer.layout(other_missing_flags);
  const SwarmPlan swarm = plan_of(flags);
  const SwimmerType& type = layout.types.at("a");
  layout.domain.box = swarm_box(swarm, type);
  layout.swimmers = swarm_swimmers(swarm, type, "a");
  return layout;
}

}  // namespace

Command add_swimmer_command(CLI::App& program) {
  CLI::App* const command = program.add_subcommand(
      "swimmer",
      "Writes a layout of one swimmer: a preset, changed by flags, or a scene that flags describe "
      "completely.");
  const auto flags = std::make_shared<OneSwimmerFlags>(*command);
  begin_group(*command, "Output");
  command->add_flag("--jsonl", flags->json_lines,
                    "Write the layout on one line, for streams of layouts (JSON Lines).");
  set_footer(
      *command,
      {"beadswim-layout swimmer --preset paper-single --box 72,30,30 --boundary periodic >layout.json",
       "beadswim-layout swimmer --radius 2 --arm 10 --stiffness 0.03 --amplitude 0.1 --period 4000 \\\n"
       "--viscosity 0.3 --unbounded >open.json"},
      "formats/layout.md");
  return {.flags = command,
          .run =
              [flags, &program] {
                write_made_layout(layout_of(*flags), program, flags->json_lines ? dump_json_line : dump_json);
              },
          .make = [flags] { return layout_of(*flags); }};
}

Command add_swarm_command(CLI::App& program) {
  CLI::App* const command = program.add_subcommand(
      "swarm",
      "Writes a layout of many swimmers with axes along x, in equal blocks that fill a periodic box, as in "
      "figure 4 of Pickl et al. 2017.");
  const auto flags = std::make_shared<SwarmFlags>(*command);
  begin_group(*command, "Blocks");
  const CLI::Validator counts = number_list({3}, whole_positive());
  const CLI::Validator gaps = number_list({1, 3}, finite_positive());
  add_value(*command, "--block-swimmers", flags->block_swimmers, {"NX,NY,NZ", counts, "1,3,3"},
            "Number of swimmers in one block along x, y, z");
  add_value(*command, "--blocks", flags->blocks, {"BX,BY,BZ", counts, "1,1,1"},
            "Number of blocks along x, y, z");
  add_value(*command, "--core-gap", flags->core_gap, {"C|CX,CY,CZ", gaps},
            "Distance between neighbouring swimmers of one block: along x between the centres of their "
            "facing end beads, along y and z between their axes [length]");
  add_value(*command, "--block-gap", flags->block_gap, {"D|DX,DY,DZ", gaps},
            "Distance between neighbouring swimmers of adjacent blocks, also across the periodic boundary; "
            "measured as for --core-gap [length]");
  set_footer(
      *command,
      {"beadswim-layout swarm --preset paper-uniform --block-swimmers 1,2,2 --blocks 2,1,1 >swarm.json",
       "beadswim-layout swarm --preset paper-defect | beadswim-layout check"},
      "swarms.md");
  return {.flags = command,
          .run = [flags, &program] { write_made_layout(layout_of(*flags), program); },
          .make = [flags] { return layout_of(*flags); }};
}

}  // namespace beadswim
