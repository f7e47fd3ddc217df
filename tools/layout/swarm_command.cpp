#include "swarm_command.hpp"

#include <fmt/core.h>

#include "beadswim/core/error.hpp"
#include "beadswim/documents/layout_document.hpp"
#include "beadswim/scene/presets.hpp"
#include "beadswim/tools/program.hpp"
#include "sound_layout.hpp"

namespace beadswim {
namespace {

constexpr double most_swimmers = 1e6;

Index3 index_of(const std::string& text) {
  return vector_of(text).array().cast<int>();
}

}  // namespace

SwarmCommand::SwarmCommand(CLI::App& program)
    : command_(
          program.add_subcommand("swarm",
                                 "A layout of many swimmers along x, in equal blocks that fill a periodic "
                                 "box, as in the paper's figure 4.")),
      flags_(
          *command_, {{"paper-uniform", paper_swarm}, {"paper-defect", paper_swarm}},
          "both are radius 6, arm 32, stiffness 0.2, no dashpots, amplitude 2, phase pi/2, period 2000, "
          "viscosity 1/3, densities 1, in blocks of 1,3,3 with the paper's own resolution as a hint; "
          "paper-uniform has gaps of 32 throughout, paper-defect a core gap of 37 and block gaps of "
          "56,46,46. The paper gives no stiffness: with its single swimmer's 0.0347 the beads would collide. "
          "Default: none; then --radius, --arm, --stiffness, --amplitude, --period, --viscosity, --core-gap "
          "and --block-gap are needed.") {
  command_
      ->add_option("--block-swimmers", block_swimmers_, "Swimmers of a block along x, y, z. Default: 1,3,3.")
      ->type_name("NX,NY,NZ")
      ->check(number_list({3}, whole_positive()));
  command_->add_option("--blocks", blocks_, "Blocks along x, y, z. Default: 1,1,1.")
      ->type_name("BX,BY,BZ")
      ->check(number_list({3}, whole_positive()));
  command_
      ->add_option("--core-gap", core_gap_,
                   "C, between neighbours of one block: across x between their lines, along x between the "
                   "centres of the end beads that face each other; one for all or one each along x, y, z "
                   "[length]. Default: the preset's.")
      ->type_name("C|CX,CY,CZ")
      ->check(number_list({1, 3}, finite_positive()));
  command_
      ->add_option("--block-gap", block_gap_,
                   "D, between neighbours of two blocks, likewise; the outermost swimmers are as far from "
                   "their periodic images [length]. Default: the preset's.")
      ->type_name("D|DX,DY,DZ")
      ->check(number_list({1, 3}, finite_positive()));
}

SwarmPlan SwarmCommand::plan() const {
  SwarmPlan plan;
  if (flags_.preset() == "paper-uniform") plan = paper_uniform_plan();
  if (flags_.preset() == "paper-defect") plan = paper_defect_plan();
  if (!block_swimmers_.empty()) plan.block_swimmers = index_of(block_swimmers_);
  if (!blocks_.empty()) plan.blocks = index_of(blocks_);
  if (!core_gap_.empty()) plan.core_gap = vector_of(core_gap_);
  if (!block_gap_.empty()) plan.block_gap = vector_of(block_gap_);
  const double swimmers = plan.block_swimmers.cast<double>().prod() * plan.blocks.cast<double>().prod();
  if (swimmers > most_swimmers) {
    throw InputError("--blocks",
                     fmt::format("make {:g} swimmers in all; at most {:g}", swimmers, most_swimmers));
  }
  return plan;
}

void SwarmCommand::run(const CLI::App& program) const {
  std::vector<std::string> further;
  if (core_gap_.empty()) further.emplace_back("--core-gap");
  if (block_gap_.empty()) further.emplace_back("--block-gap");
  LayoutDocument document{.layout = flags_.layout(further), .provenance = {provenance_record(program)}};
  Layout& layout = document.layout;
  const SwarmPlan swarm = plan();
  const SwimmerType& type = layout.types.at("a");
  layout.domain = swarm_box(swarm, type);
  layout.swimmers = swarm_swimmers(swarm, type, "a");
  require_sound(layout, "the flags");
  write_text("-", dump_json(layout_to_json(document)));
}

}  // namespace beadswim
