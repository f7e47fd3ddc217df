#include <fmt/core.h>

#include <algorithm>

#include "beadswim/core/error.hpp"
#include "beadswim/figure/svg_conversion.hpp"
#include "beadswim/io/json.hpp"
#include "beadswim/tools/program.hpp"
#include "kinds.hpp"

// beadswim-plot: figures of run records, predictions, verdicts, trajectories and layouts.

namespace {

using namespace beadswim;

void require_figure_path(const std::string& path) {
  if (path == "-" || path.ends_with(".svg") || path.ends_with(".png") || path.ends_with(".pdf")) return;
  throw InputError("--output", fmt::format("the file name \"{}\" does not end in .svg, .png or .pdf; give a "
                                           "name with one of these endings, or - for SVG on standard output",
                                           path));
}

void require_data_path(const PlotFiles& files) {
  if (files.data.empty()) return;
  if (!files.data.ends_with(".csv") && files.data != "-")
    throw InputError("--data", fmt::format("the file name \"{}\" does not end in .csv; give a name with this "
                                           "ending, or - for standard output",
                                           files.data));
  if (files.data == files.output)
    throw InputError("--data", "figure and data have the same file name; name two files");
}

int run(int argc, const char* const* argv) {
  const auto program = make_program(
      "beadswim-plot",
      "Draws run records, predictions, verdicts, trajectories and layouts as a figure: SVG, PNG or PDF.");
  program->require_subcommand(1);
  PlotFiles files;
  std::vector<std::pair<CLI::App*, Drawing>> commands;
  for (const PlotKind& kind : plot_kinds()) {
    CLI::App* command = program->add_subcommand(kind.name, kind.description);
    command->add_option("FILES", files.inputs, kind.inputs)->type_name("FILE...")->default_str("");
    command
        ->add_option("-o,--output", files.output,
                     "Figure to write: .svg, .png, .pdf, or - for SVG on standard output")
        ->type_name("FILE");
    command
        ->add_option("--data", files.data,
                     "File to write with the numbers drawn, as comma-separated values with names and units")
        ->type_name("FILE.csv")
        ->default_str("none");
    commands.emplace_back(command, kind.add_flags(*command));
    const std::string of_kind = command->get_footer();
    set_footer(*command, {kind.examples.begin(), kind.examples.end()}, "figures.md");
    command->footer(of_kind + command->get_footer());
  }
  set_footer(*program,
             {"beadswim-plot stroke run.json theory.json -o stroke.svg",
              "beadswim-plot trajectories run.h5md -o trajectory.svg"},
             "figures.md");
  if (const auto done = parse_command_line(*program, argc, argv)) return *done;
  require_figure_path(files.output);
  require_data_path(files);
  for (const std::string& input : files.inputs)
    for (const std::string& output : {files.output, files.data}) require_other_file(input, output);
  const auto chosen = [](const auto& each) { return each.first->parsed(); };
  const Drawn drawn = std::ranges::find_if(commands, chosen)->second(files);
  const bool is_svg = files.output == "-" || files.output.ends_with(".svg");
  write_text(files.output, is_svg ? drawn.svg : converted_svg(drawn.svg, files.output));
  if (!files.data.empty()) write_text(files.data, drawn.csv);
  return static_cast<int>(ExitStatus::fine);
}

}  // namespace

int main(int argc, char** argv) {
  return beadswim::guarded_main("beadswim-plot", [&] { return run(argc, argv); });
}
