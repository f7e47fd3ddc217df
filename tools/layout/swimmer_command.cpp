#include "swimmer_command.hpp"

#include "beadswim/core/error.hpp"
#include "beadswim/documents/layout_document.hpp"
#include "beadswim/scene/presets.hpp"
#include "beadswim/tools/program.hpp"
#include "sound_layout.hpp"

namespace beadswim {

SwimmerCommand::SwimmerCommand(CLI::App& program)
    : command_(program.add_subcommand(
          "swimmer", "A layout of one swimmer: a preset, changed by any of the flags, or the flags alone.")),
      flags_(
          *command_, {{"paper-single", paper_single}},
          "paper-single is radius 4, arm 20, stiffness 0.0347, no dashpots, amplitude 0.2, phase pi/2, "
          "period 4800, viscosity 1/3, densities 1, in a free-slip box 1200,800,800, with the paper's own "
          "resolution as a hint (cells and time steps are the units of length and time). Default: none; then "
          "--radius, --arm, --stiffness, --amplitude, --period, --viscosity and one of --box and --unbounded "
          "are needed."),
      place_(*command_) {
  command_->add_flag(
      "--jsonl", json_lines_,
      "Write the layout on one line, for streams of one layout a line (beadswim-theory --jsonl).");
}

void SwimmerCommand::run(const CLI::App& program) const {
  LayoutDocument document{
      .layout = flags_.layout(place_.say_box() ? std::vector<std::string>{}
                                               : std::vector<std::string>{"--box or --unbounded"}),
      .provenance = {provenance_record(program)}};
  place_.apply(document.layout);
  require_sound(document.layout, "the flags");
  const Json json = layout_to_json(document);
  write_text("-", json_lines_ ? dump_json_line(json) : dump_json(json));
}

}  // namespace beadswim
