#include <fmt/core.h>

#include <algorithm>

#include "beadswim/core/error.hpp"
#include "beadswim/core/nearest_name.hpp"
#include "beadswim/tools/program.hpp"
#include "plot_inputs.hpp"
#include "stroke_figure.hpp"
#include "velocity_figure.hpp"
#include "write_figure.hpp"

namespace {

using namespace beadswim;

const std::vector<std::string> kinds{"stroke", "velocity-against-period"};

struct PlotRequest {
  std::string kind;
  std::vector<std::string> files;
  std::string output = "-";
  std::vector<std::string> methods;
  std::string cycle = "last";
};

void add_flags(CLI::App& program, PlotRequest& request) {
  program
      .add_option("KIND", request.kind,
                  "stroke: arm amplitudes and phase shift by cycle. velocity-against-period: velocity along "
                  "the swimmer's axis, against the mean flow along periodic axes.")
      ->type_name("stroke|velocity-against-period");
  program
      .add_option(
          "FILES", request.files,
          "Run records (drawn as points) and predictions (as lines). One may be - for standard input.")
      ->type_name("FILE...")
      ->default_str("");
  program.add_option("-o,--output", request.output, "Figure to write: .svg, .png, or - for SVG on stdout.")
      ->type_name("FILE");
  program
      .add_option(
          "--method", request.methods,
          "Methods to draw of each prediction, separated by commas; the best usable one unless given.")
      ->type_name("NAME,...")
      ->delimiter(',')
      ->default_str("the best");
  program
      .add_option(
          "--cycle", request.cycle,
          "Cycle of each run for velocity-against-period: last, N (the Nth from the run's start) or mean:N "
          "(mean of the last N).")
      ->type_name("last|N|mean:N");
}

Figure draw(const PlotRequest& request) {
  const CycleChoice cycle = parse_cycle_choice(request.cycle);
  const PlotInputs inputs = read_plot_inputs(request.files, request.methods);
  return request.kind == "stroke" ? stroke_figure(inputs) : velocity_figure(inputs, cycle);
}

void require_kind(const std::string& kind) {
  const std::string list = CLI::detail::join(kinds, ", ");
  if (kind.empty()) throw InputError("KIND", "none given; there are " + list);
  if (std::find(kinds.begin(), kinds.end(), kind) != kinds.end()) return;
  throw InputError("KIND", fmt::format("unknown \"{}\"; did you mean \"{}\"? There are {}", kind,
                                       nearest_name(kind, kinds), list));
}

int run(int argc, const char* const* argv) {
  const auto program =
      make_program("beadswim-plot", "Draws run records and predictions as a figure, SVG or PNG.");
  PlotRequest request;
  add_flags(*program, request);
  if (const auto done = parse_command_line(*program, argc, argv)) return *done;
  require_kind(request.kind);
  require_figure_path(request.output);
  for (const std::string& file : request.files) require_other_file(file, request.output);
  write_figure(request.output, figure_to_svg(draw(request)));
  return static_cast<int>(ExitStatus::fine);
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return run(argc, argv);
  } catch (...) {
    return beadswim::report_current_exception("beadswim-plot");
  }
}
