#include "swimmer_command.hpp"

#include "beadswim/core/error.hpp"
#include "beadswim/documents/layout_document.hpp"
#include "beadswim/scene/presets.hpp"
#include "beadswim/tools/program.hpp"
#include "sound_layout.hpp"

namespace beadswim {

SwimmerCommand::SwimmerCommand(CLI::App& program)
    : command_(program.add_subcommand("swimmer",
                                      "Writes a layout of one swimmer: a preset, changed by flags, or a "
                                      "scene that flags describe completely.")),
      flags_(*command_, {{"paper-single", paper_single}},
             "Scene that replaces missing flags: paper-single (single swimmer of Pickl et al. 2017). Without "
             "it, flags without a default are required"),
      place_(*command_, "bead 2, the middle bead", "from bead 1 to bead 3", "the preset's, else periodic") {
  begin_group(*command_, "Output");
  command_->add_flag("--jsonl", json_lines_,
                     "Write the layout on one line, for streams of layouts (JSON Lines).");
  set_footer(
      *command_,
      {"beadswim-layout swimmer --preset paper-single --box 72,30,30 --boundary periodic >layout.json",
       "beadswim-layout swimmer --radius 2 --arm 10 --stiffness 0.03 --amplitude 0.1 --period 4000 \\\n"
       "--viscosity 0.3 --unbounded >open.json"},
      "formats/layout.md");
}

void SwimmerCommand::run(const CLI::App& program) const {
  LayoutDocument document{
      .layout = flags_.layout(place_.defines_domain()
                                  ? std::vector<std::string>{}
                                  : std::vector<std::string>{"--box, --unbounded or --half-space"}),
      .provenance = {provenance_record(program)}};
  place_.apply(document.layout);
  require_sound(document.layout, "the flags");
  const Json json = layout_to_json(document);
  write_text("-", json_lines_ ? dump_json_line(json) : dump_json(json));
}

}  // namespace beadswim
