#include "beadswim/core/error.hpp"
#include "beadswim/documents/layout_document.hpp"
#include "beadswim/scene/presets.hpp"
#include "beadswim/tools/program.hpp"
#include "commands.hpp"
#include "sound_layout.hpp"
#include "swimmer_flags.hpp"

namespace beadswim {
namespace {

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

void write_swimmer(const OneSwimmerFlags& flags, const CLI::App& program) {
  LayoutDocument document{
      .layout = flags.swimmer.layout(flags.place.defines_domain()
                                         ? std::vector<std::string>{}
                                         : std::vector<std::string>{"--box, --unbounded or --half-space"}),
      .provenance = {provenance_record(program)}};
  flags.place.apply(document.layout);
  require_sound(document.layout, "the flags");
  const Json json = layout_to_json(document);
  write_text("-", flags.json_lines ? dump_json_line(json) : dump_json(json));
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
  return {command, [flags, &program] { write_swimmer(*flags, program); }};
}

}  // namespace beadswim
