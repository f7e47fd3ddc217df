#include "beadswim/core/error.hpp"
#include "beadswim/tools/program.hpp"
#include "plot_inputs.hpp"
#include "plot_request.hpp"
#include "product_figure.hpp"
#include "speed_figure.hpp"
#include "stroke_figure.hpp"
#include "swimmer_figure.hpp"
#include "velocity_figure.hpp"
#include "verdict_figure.hpp"
#include "write_figure.hpp"

// beadswim-plot: figures of run records, predictions, verdicts, trajectories and layouts.

namespace {

using namespace beadswim;

Figure draw(const PlotRequest& request) {
  const CycleChoice cycle = parse_cycle_choice(request.cycle);
  const auto against = parse_against(request.against);
  const Axes axes = parse_axes(request.axes);
  if (request.kind == products_kind) return product_figure(request.files);
  if (request.kind == trajectories_kind) return trajectory_figure(request.files, trajectory_options(request));
  if (request.kind == speed_kind && request.reference.empty())
    return verdict_figure(request.files, request.methods);
  if (request.kind == speed_kind) {
    return speed_figure(read_plot_inputs(request.files, {}), {request.reference, request.methods, cycle});
  }
  const PlotInputs inputs = read_plot_inputs(request.files, {request.methods, request.relative_to});
  if (request.kind == stroke_kind) {
    return against ? stroke_against(inputs, *against, cycle) : stroke_by_cycle(inputs);
  }
  const Abscissa abscissa = request.kind == separation_kind ? Abscissa::separation_ratio : Abscissa::period;
  return velocity_figure(inputs, {abscissa, cycle, axes});
}

std::string svg_of(const PlotRequest& request) {
  if (request.kind == swarm_kind)
    return swarm_picture_to_svg(swarm_figure(request.files, swarm_options(request)));
  if (request.kind == swimmer_kind)
    return swimmer_sketch_to_svg(swimmer_figure(request.files, sketched_swimmer(request)));
  return figure_to_svg(draw(request));
}

int run(int argc, const char* const* argv) {
  const auto program = make_program(
      "beadswim-plot",
      "Draws run records, predictions, verdicts, trajectories and layouts as a figure, SVG or PNG.");
  PlotRequest request;
  add_flags(*program, request);
  if (const auto done = parse_command_line(*program, argc, argv)) return *done;
  require_consistent(request);
  require_figure_path(request.output);
  for (const std::string& file : request.files) require_other_file(file, request.output);
  if (!request.reference.empty()) require_other_file(request.reference, request.output);
  write_figure(request.output, svg_of(request));
  return static_cast<int>(ExitStatus::fine);
}

}  // namespace

int main(int argc, char** argv) {
  return beadswim::guarded_main("beadswim-plot", [&] { return run(argc, argv); });
}
