#include <fmt/core.h>

#include "beadswim/core/error.hpp"
#include "beadswim/documents/layout_document.hpp"
#include "beadswim/scene/presets.hpp"
#include "beadswim/scene/swarm.hpp"
#include "beadswim/tools/program.hpp"
#include "commands.hpp"
#include "sound_layout.hpp"
#include "swimmer_flags.hpp"

namespace beadswim {
namespace {

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
    throw InputError("--blocks", fmt::format("the blocks have {:g} swimmers in total, but at most {:g} are "
                                             "possible; use fewer or smaller blocks",
                                             swimmers, max_swimmers));
  }
  return plan;
}

void write_swarm(const SwarmFlags& flags, const CLI::App& program) {
  std::vector<std::string> other_missing_flags;
  if (flags.core_gap.empty()) other_missing_flags.emplace_back("--core-gap");
  if (flags.block_gap.empty()) other_missing_flags.emplace_back("--block-gap");
  LayoutDocument document{.layout = flags.swimmer.layout(other_missing_flags),
                          .provenance = {provenance_record(program)}};
  Layout& layout = document.layout;
  const SwarmPlan swarm = plan_of(flags);
  const SwimmerType& type = layout.types.at("a");
  layout.domain.box = swarm_box(swarm, type);
  layout.swimmers = swarm_swimmers(swarm, type, "a");
  require_sound(layout, "the flags");
  write_text("-", dump_json(layout_to_json(document)));
}

}  // namespace

Command add_swarm_command(CLI::App& program) {
  CLI::App* const command = program.add_subcommand(
      "swarm",
      "Writes a layout of many swimmers with axes along x, in equal blocks that fill a periodic box, as in "
      "figure 4 of Pickl et al. 2017.");
  const auto flags = std::make_shared<SwarmFlags>(*command);
  begin_group(*command, "Blocks");
  command
      ->add_option("--block-swimmers", flags->block_swimmers, "Number of swimmers in one block along x, y, z")
      ->type_name("NX,NY,NZ")
      ->check(number_list({3}, whole_positive()))
      ->default_str("1,3,3");
  command->add_option("--blocks", flags->blocks, "Number of blocks along x, y, z")
      ->type_name("BX,BY,BZ")
      ->check(number_list({3}, whole_positive()))
      ->default_str("1,1,1");
  command
      ->add_option("--core-gap", flags->core_gap,
                   "Distance between neighbouring swimmers of one block: along x between the centres of "
                   "their facing end beads, along y and z between their axes [length]")
      ->type_name("C|CX,CY,CZ")
      ->check(number_list({1, 3}, finite_positive()));
  command
      ->add_option("--block-gap", flags->block_gap,
                   "Distance between neighbouring swimmers of adjacent blocks, also across the periodic "
                   "boundary; measured as for --core-gap [length]")
      ->type_name("D|DX,DY,DZ")
      ->check(number_list({1, 3}, finite_positive()));
  set_footer(
      *command,
      {"beadswim-layout swarm --preset paper-uniform --block-swimmers 1,2,2 --blocks 2,1,1 >swarm.json",
       "beadswim-layout swarm --preset paper-defect | beadswim-layout check"},
      "swarms.md");
  return {command, [flags, &program] { write_swarm(*flags, program); }};
}

}  // namespace beadswim
