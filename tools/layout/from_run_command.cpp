#include "beadswim/core/error.hpp"
#include "beadswim/documents/continued_layout.hpp"
#include "beadswim/tools/named_flags.hpp"
#include "commands.hpp"
#include "layout_output.hpp"

namespace beadswim {
namespace {

struct FromRunFlags {
  std::string file;
  std::optional<int> cycle;
  bool json_lines = false;
};

void write_continued(const FromRunFlags& flags, const CLI::App& program) {
  LayoutDocument document = layout_after_cycle(flags.file, flags.cycle, "--cycle");
  require_sound(document.layout, "the positions of the beads");
  write_layout(std::move(document), program, flags.json_lines ? dump_json_line : dump_json);
}

}  // namespace

Command add_from_run_command(CLI::App& program) {
  const auto flags = std::make_shared<FromRunFlags>();
  CLI::App* const command = program.add_subcommand(
      "from-run",
      "Writes a layout that starts where a run was: with its bead positions and driving phases, and with "
      "beads and fluid at rest.");
  add_value(*command, "run", flags->file, {.name = "FILE"}, "Trajectory file of the run (H5MD)")->required();
  const CLI::Validator cycles(
      [](const std::string& text) {
        return text == "last" ? std::string{} : whole_number(0, 1000000000)(text);
      },
      "");
  const auto take = [flags](const std::string& text) {
    if (text != "last") flags->cycle = std::stoi(text);
  };
  add_value(*command, "--cycle", take, {"last|N", cycles, "last"},
            "Number of the base cycle at whose end the layout starts; 0 is the start of the run");
  command->add_flag("--jsonl", flags->json_lines, "Write the layout on one line.");
  set_footer(
      *command,
      {"beadswim-run layout.json --model rpy --cycles 2 -o past.h5md >past.json && \\\n"
       "beadswim-layout from-run past.h5md >continued.json",
       "beadswim-layout from-run past.h5md --cycle 1 | beadswim-run - --model rpy -o next.h5md >next.json"},
      "long-runs.md");
  return {command, [flags, &program] { write_continued(*flags, program); }};
}

}  // namespace beadswim
