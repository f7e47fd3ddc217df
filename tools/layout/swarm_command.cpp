#include "swarm_command.hpp"

#include <fmt/core.h>

#include "beadswim/core/error.hpp"
#include "beadswim/documents/layout_document.hpp"
#include "beadswim/scene/presets.hpp"
#include "beadswim/tools/program.hpp"
#include "sound_layout.hpp"

namespace beadswim {
namespace {

constexpr double max_swimmers = 1e6;

Index3 index_of(const std::string& text) {
  return parse_vector(text).array().cast<int>();
}

}  // namespace

SwarmCommand::SwarmCommand(CLI::App& program)
    : command_(program.add_subcommand("swarm",
                                      "Writes a layout of many swimmers with axes along x, in equal blocks "
                                      "that fill a periodic box, as in figure 4 of Pickl et al. 2017.")),
      flags_(*command_, {{"paper-uniform", paper_swarm}, {"paper-defect", paper_swarm}},
             "Swarm of Pickl et al. 2017 that replaces missing flags: paper-uniform (all gaps 32) or "
             "paper-defect (core gap 37, block gaps 56,46,46)") {
  begin_group(*command_, "Blocks");
  command_->add_option("--block-swimmers", block_swimmers_, "Number of swimmers in one block along x, y, z")
      ->type_name("NX,NY,NZ")
      ->check(number_list({3}, whole_positive()))
      ->default_str("1,3,3");
  command_->add_option("--blocks", blocks_, "Number of blocks along x, y, z")
      ->type_name("BX,BY,BZ")
      ->check(number_list({3}, whole_positive()))
      ->default_str("1,1,1");
  command_
      ->add_option("--core-gap", core_gap_,
                   "Distance between neighbouring swimmers of one block: along x between the centres of "
                   "their facing end beads, along y and z between their axes [length]")
      ->type_name("C|CX,CY,CZ")
      ->check(number_list({1, 3}, finite_positive()));
  command_
      ->add_option("--block-gap", block_gap_,
                   "Distance between neighbouring swimmers of adjacent blocks, also across the periodic "
                   "boundary; measured as for --core-gap [length]")
      ->type_name("D|DX,DY,DZ")
      ->check(number_list({1, 3}, finite_positive()));
  set_footer(
      *command_,
      {"beadswim-layout swarm --preset paper-uniform --block-swimmers 1,2,2 --blocks 2,1,1 >swarm.json",
       "beadswim-layout swarm --preset paper-defect | beadswim-layout check"},
      "swarms.md");
}

SwarmPlan SwarmCommand::plan() const {
  SwarmPlan plan;
  if (flags_.preset() == "paper-uniform") plan = paper_uniform_plan();
  if (flags_.preset() == "paper-defect") plan = paper_defect_plan();
  if (!flags_.preset().empty()) {
    const double unit = flags_.preset_units().length;
    plan.core_gap *= unit;
    plan.block_gap *= unit;
  }
  if (!block_swimmers_.empty()) plan.block_swimmers = index_of(block_swimmers_);
  if (!blocks_.empty()) plan.blocks = index_of(blocks_);
  if (!core_gap_.empty()) plan.core_gap = parse_vector(core_gap_);
  if (!block_gap_.empty()) plan.block_gap = parse_vector(block_gap_);
  const double swimmers = plan.block_swimmers.cast<double>().prod() * plan.blocks.cast<double>().prod();
  if (swimmers > max_swimmers) {
    throw InputError("--blocks", fmt::format("the blocks have {:g} swimmers in total, but at most {:g} are "
                                             "possible; use fewer or smaller blocks",
                                             swimmers, max_swimmers));
  }
  return plan;
}

void SwarmCommand::run(const CLI::App& program) const {
  std::vector<std::string> other_missing_flags;
  if (core_gap_.empty()) other_missing_flags.emplace_back("--core-gap");
  if (block_gap_.empty()) other_missing_flags.emplace_back("--block-gap");
  LayoutDocument document{.layout = flags_.layout(other_missing_flags),
                          .provenance = {provenance_record(program)}};
  Layout& layout = document.layout;
  const SwarmPlan swarm = plan();
  const SwimmerType& type = layout.types.at("a");
  layout.domain.box = swarm_box(swarm, type);
  layout.swimmers = swarm_swimmers(swarm, type, "a");
  require_sound(layout, "the flags");
  write_text("-", dump_json(layout_to_json(document)));
}

}  // namespace beadswim
