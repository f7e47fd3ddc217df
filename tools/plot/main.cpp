#include <fmt/core.h>

#include <algorithm>

#include "beadswim/core/error.hpp"
#include "beadswim/figure/png.hpp"
#include "beadswim/io/json.hpp"
#include "beadswim/tools/program.hpp"
#include "kinds.hpp"

// beadswim-plot: figures of run records, predictions, verdicts, trajectories and layouts.

namespace {

using namespace beadswim;

void require_figure_path(const std::string& path) {
  if (path == "-" || path.ends_with(".svg") || path.ends_with(".png")) return;
  throw InputError("--output", fmt::format("the file name \"{}\" ends in neither .svg nor .png; give a name "
                                           "with one of these endings, or - for SVG on standard output",
                                           path));
}

int run(int argc, const char* const* argv) {
  const auto program = make_program(
      "beadswim-plot",
      "Draws run records, predictions, verdicts, trajectories and layouts as a figure, SVG or PNG.");
  program->require_subcommand(1);
  PlotFiles files;
  std::vector<std::pair<CLI::App*, Drawing>> commands;
  for (const PlotKind& kind : plot_kinds()) {
    CLI::App* command = program->add_subcommand(kind.name, kind.description);
    command->add_option("FILES", files.inputs, kind.inputs)->type_name("FILE...")->default_str("");
    command
        ->add_option("-o,--output", files.output,
                     "Figure to write: .svg, .png, or - for SVG on standard output")
        ->type_name("FILE");
    commands.emplace_back(command, kind.add_flags(*command));
    set_footer(*command, {kind.examples.begin(), kind.examples.end()}, "figures.md");
  }
  set_footer(*program,
             {"beadswim-plot stroke run.json theory.json -o stroke.svg",
              "beadswim-plot trajectories run.h5md -o trajectory.svg"},
             "figures.md");
  if (const auto done = parse_command_line(*program, argc, argv)) return *done;
  require_figure_path(files.output);
  for (const std::string& input : files.inputs) require_other_file(input, files.output);
  const auto chosen = [](const auto& each) { return each.first->parsed(); };
  const std::string svg = std::ranges::find_if(commands, chosen)->second(files);
  write_text(files.output, files.output.ends_with(".png") ? svg_to_png(svg, files.output) : svg);
  return static_cast<int>(ExitStatus::fine);
}

}  // namespace

int main(int argc, char** argv) {
  return beadswim::guarded_main("beadswim-plot", [&] { return run(argc, argv); });
}
