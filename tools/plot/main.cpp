#include <algorithm>
#include <array>

#include "beadswim/core/error.hpp"
#include "beadswim/io/json.hpp"
#include "beadswim/tools/program.hpp"
#include "kinds.hpp"

// beadswim-plot: figures of run records, predictions, verdicts, trajectories, flow fields and layouts.

namespace {

using namespace beadswim;

/// A kind of figure.
struct PlotKind {
  const char* name;
  const char* description;
  const char* inputs;                          ///< help on the input files
  DrawFigure (*add_flags)(CLI::App& command);  ///< adds flags, and returns the function that draws
  std::array<const char*, 2> examples;         ///< examples at the end of the help
};

constexpr const char* records_and_predictions =
    "Run records (drawn as points) and predictions (drawn as lines), one document per file or one per line; "
    "- is standard input.";
constexpr const char* trajectories =
    "Trajectory files of beadswim-run (.h5md), or the files of unfinished runs (.h5md.part).";

constexpr std::array kinds{
    PlotKind{"stroke",
             "Draws arm amplitudes and phase shift against the cycle, or against a driving parameter.",
             records_and_predictions,
             add_stroke_flags,
             {"beadswim-plot stroke run.json theory.json -o stroke.svg",
              "beadswim-plot stroke run.json lbm.json -o strokes.svg"}},
    PlotKind{"velocity-against-period",
             "Draws the velocity along the swimmer's axis, minus mean flow, against the driving period.",
             records_and_predictions,
             [](CLI::App& command) { return add_velocity_flags(command, AbscissaKind::period); },
             {"beadswim-plot velocity-against-period study.jsonl -o velocity.svg",
              "beadswim-plot velocity-against-period study.jsonl --method all --axes linear -o methods.svg"}},
    PlotKind{
        "against",
        "Draws a result of a study against a quantity that beadswim-layout vary has varied.",
        records_and_predictions,
        add_against_flags,
        {"beadswim-layout swimmer --preset paper-single --unbounded | \\\n"
         "beadswim-layout vary --over stiffness=0.01:0.1:9:log --over phase=45deg,90deg | \\\n"
         "beadswim-theory --method rpy-ode >stiffness.jsonl",
         "beadswim-plot against stiffness.jsonl --x stiffness --group-by phase --log x -o stiffness.svg"}},
    PlotKind{"separation",
             "Draws the velocity along the axis, minus mean flow, against arm length over bead radius.",
             records_and_predictions,
             [](CLI::App& command) { return add_velocity_flags(command, AbscissaKind::separation_ratio); },
             {"for L in 15 20 30; do \\\n"
              "beadswim-layout swimmer --preset paper-single --unbounded --arm $L --jsonl; done | \\\n"
              "beadswim-theory --jsonl >arms.jsonl",
              "beadswim-plot separation arms.jsonl -o separation.svg"}},
    PlotKind{"speed-against-error",
             "Draws the errors of velocity and arm amplitudes against the cost of runs in core-seconds.",
             "Run records (with --reference) or verdicts of beadswim-compare, one document per file or one "
             "per line; - is standard input.",
             add_speed_flags,
             {"beadswim-plot speed-against-error run.json lbm.json --reference theory.json -o speed.svg",
              "beadswim-plot speed-against-error verdict.json -o verdict.svg"}},
    PlotKind{"trajectories",
             "Draws one coordinate of beads against time, or against the angle of the swimmer's axis.",
             trajectories,
             add_trajectory_flags,
             {"beadswim-plot trajectories run.h5md -o trajectory.svg",
              "beadswim-plot trajectories run.h5md --along z --against angle -o heights.svg"}},
    PlotKind{"msd",
             "Draws the mean square displacement of swimmers, and the turn of their axes, against time.",
             "Trajectory files of runs with thermal noise (.h5md), drawn as points; predictions for their "
             "layouts, drawn as lines.",
             add_diffusion_flags,
             {"beadswim-layout swimmer --preset paper-single --unbounded | \\\n"
              "beadswim-layout vary --over thermal-energy=0.01,0.02 | \\\n"
              "beadswim-run --model rpy --cycles 12 -o warm-{}.h5md >warm.jsonl",
              "beadswim-plot msd warm-1.h5md warm-2.h5md -o msd.svg"}},
    PlotKind{"swarm",
             "Draws all beads and bonds of a layout, or of one frame of a trajectory.",
             "Layout file (- is standard input), trajectory file (.h5md), or file of an unfinished run "
             "(.h5md.part).",
             add_swarm_flags,
             {"beadswim-plot swarm swarm.json --block-swimmers 1,2,2 -o swarm.svg",
              "beadswim-plot swarm run.h5md --frame 0 --repeat 1,2,2 -o frame.svg"}},
    PlotKind{"flow",
             "Draws the flow in a plane: streamlines or arrows on a map of the speed or of a component.",
             "Flow file of beadswim-run (.vti), or trajectory file (.h5md), for the last flow of its run.",
             add_flow_flags,
             {"beadswim-plot flow lbm.h5md --plane xz -o flow.svg",
              "beadswim-plot flow lbm.h5md --quantity ux --style arrows -o flow.png"}},
    PlotKind{"swimmer",
             "Draws a labelled sketch of one three-bead swimmer of a layout.",
             "Layout file (JSON); - is standard input.",
             add_swimmer_flags,
             {"beadswim-plot swimmer layout.json -o swimmer.svg",
              "beadswim-plot swimmer swarm.json --swimmers 3 -o third.svg"}},
    PlotKind{"mobility-products",
             "Draws the time of mobility products (velocities from forces) against the number of beads.",
             "Results of beadswim-bench --beads --json; - is standard input.",
             add_product_flags,
             {"beadswim-plot mobility-products products.json -o products.svg",
              "beadswim-bench --beads 99,999 --json | beadswim-plot mobility-products - -o products.svg"}}};

void require_figure_path(const std::string& path) {
  if (path == "-" || path.ends_with(".svg") || path.ends_with(".png") || path.ends_with(".pdf")) return;
  throw InputError("--output",
                   "the file name \"{}\" does not end in .svg, .png or .pdf; give a name with one of these "
                   "endings, or - for SVG on standard output",
                   path);
}

void require_data_path(const PlotFiles& files) {
  if (files.data.empty()) return;
  require_csv_path(files.data, "--data");
  if (files.data == files.output)
    throw InputError("--data", "figure and data have the same file name; name two files");
}

int run(int argc, const char* const* argv) {
  const auto program = make_program("beadswim-plot",
                                    "Draws run records, predictions, verdicts, trajectories, flow fields and "
                                    "layouts as a figure: SVG, PNG or PDF.");
  program->require_subcommand(1);
  PlotFiles files;
  std::vector<std::pair<CLI::App*, DrawFigure>> commands;
  for (const PlotKind& kind : kinds) {
    CLI::App* command = program->add_subcommand(kind.name, kind.description);
    add_value(*command, "FILES", files.inputs, {"FILE..."}, kind.inputs)->default_str("");
    add_value(*command, "-o,--output", files.output, {"FILE"},
              "Figure to write: .svg, .png, .pdf, or - for SVG on standard output");
    add_value(*command, "--data", files.data, {.name = "FILE.csv", .initial = "none"},
              "File to write with the numbers drawn, as comma-separated values with names and units");
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
  const Drawing drawn = std::ranges::find_if(commands, chosen)->second(files);
  const bool is_svg = files.output == "-" || files.output.ends_with(".svg");
  write_text(files.output, is_svg ? drawn.svg : converted_svg(drawn.svg, files.output));
  if (!files.data.empty()) write_text(files.data, drawn.csv);
  return static_cast<int>(ExitStatus::fine);
}

}  // namespace

int main(int argc, char** argv) {
  return beadswim::guarded_main("beadswim-plot", [&] { return run(argc, argv); });
}
