#include <algorithm>
#include <cmath>
#include <filesystem>
#include <memory>
#include <set>

#include "beadswim/compare/diffusion.hpp"
#include "beadswim/core/error.hpp"
#include "beadswim/documents/prediction_document.hpp"
#include "beadswim/documents/trajectory_file.hpp"
#include "beadswim/figure/figure.hpp"
#include "beadswim/scene/units.hpp"
#include "beadswim/theory/passive_diffusion.hpp"
#include "kinds.hpp"
#include "plot_labels.hpp"

// Mean square displacement and mean cosine of the turn of swimmers against time: of trajectories as points, of
// predictions as lines.

namespace beadswim {
namespace {

constexpr int lags_per_decade = 8, line_points = 200;

/// Returns the path of each swimmer at the ends of cycles.
std::vector<SwimmerPath> paths_of(const TrajectoryFile& file) {
  const std::vector<std::size_t> first = file.reader.header().first_beads();
  std::vector<SwimmerPath> paths(file.in_layout.size());
  for (std::size_t n = 0; n < file.reader.frames(); ++n) {
    if (!whole_cycles(file.reader.times()[n], file.period())) continue;
    const TrajectoryFrame frame = file.reader.frame(n);
    for (std::size_t s = 0; s < paths.size(); ++s) {
      const SwimmerType& type = file.type(s);
      const std::span beads(&frame.positions[first[s]], type.beads.size());
      paths[s].append(type, beads, file.layout.swimmers[file.in_layout[s]].orientation());
    }
  }
  return paths;
}

/// Returns numbers of cycles, evenly spaced by their logarithms.
std::set<std::size_t> lags_up_to(double longest) {
  std::set<std::size_t> lags;
  for (double lag = 1; lag <= longest; lag *= std::pow(10, 1.0 / lags_per_decade))
    lags.insert(static_cast<std::size_t>(std::round(lag)));
  return lags;
}

/// Adds the points of a trajectory to the two panels. Returns the longest lag [cycles].
double add_points(const TrajectoryFile& file, std::vector<Panel>& panels) {
  const std::vector<SwimmerPath> paths = paths_of(file);
  const std::size_t cycles = paths.empty() || paths[0].places.empty() ? 0 : paths[0].places.size() - 1;
  constexpr std::size_t fewest_windows = 10;
  const double longest =
      std::min<double>(static_cast<double>(cycles),
                       static_cast<double>(cycles * paths.size()) / static_cast<double>(fewest_windows));
  if (longest < 1)
    throw InputError(file.source, "{} cycles of {} swimmers are too few for a mean; run {} cycles or more",
                     cycles, paths.size(), fewest_windows);
  Series squares{.label = std::filesystem::path(file.source).stem().string(),
                 .colour = static_cast<int>(panels[0].series.size()),
                 .shape = static_cast<int>(panels[0].series.size())};
  Series cosines = squares;
  for (const std::size_t lag : lags_up_to(longest)) {
    const auto [square, cosine] = displacement_statistics(paths, lag);
    for (const auto& [series, value] : {std::pair(&squares, square), std::pair(&cosines, cosine)}) {
      series->x.push_back(static_cast<double>(lag));
      series->y.push_back(value.mean);
      series->errors.push_back(value.standard_error);
    }
  }
  panels[0].series.push_back(std::move(squares));
  panels[1].series.push_back(std::move(cosines));
  return longest;
}

/// Adds the lines of a prediction.
void add_lines(const PlottedPrediction& plotted, double longest, std::vector<Panel>& panels) {
  const auto& thermal = plotted.prediction().thermal;
  const auto period = find_setting<double>(plotted.prediction(), "period");
  if (!thermal || !period)
    throw InputError(plotted.source,
                     "the prediction has no thermal noise; predict a layout with --thermal-energy");
  Series squares{.label = "theory, " + plotted.prediction().method,
                 .mark = Mark::line,
                 .colour = static_cast<int>(panels[0].series.size())};
  Series cosines = squares;
  for (int n = 0; n <= line_points; ++n) {
    const double lag = std::pow(longest, n / double(line_points)), t = lag * *period;
    squares.x.push_back(lag);
    squares.y.push_back(mean_square_displacement(*thermal, plotted.prediction().velocity, t));
    cosines.x.push_back(lag);
    cosines.y.push_back(mean_cosine(*thermal, t));
  }
  panels[0].series.push_back(std::move(squares));
  panels[1].series.push_back(std::move(cosines));
}

Figure diffusion_figure(const std::vector<std::string>& paths, const InputChoice& choice) {
  std::vector<std::string> trajectories, predictions;
  for (const std::string& path : paths) (is_trajectory(path) ? trajectories : predictions).push_back(path);
  if (trajectories.empty()) throw InputError("FILES", "no trajectory is given; name a trajectory (.h5md)");
  const AxisLabel time{"time", "cycles of the driving"};
  std::vector<Panel> panels;
  double longest = 1;
  Units units;
  for (const std::string& path : trajectories) {
    const TrajectoryFile file = open_trajectory(path);
    if (panels.empty()) {
      units = file.layout.units;
      panels = {{.x_label = time,
                 .y_label = {"mean square displacement", units.lattice ? "" : length_unit(units) + "²"},
                 .x_scale = ScaleKind::logarithmic,
                 .y_scale = ScaleKind::logarithmic},
                {.x_label = time,
                 .y_label = {"mean cosine of the turn of the axis", ""},
                 .x_scale = ScaleKind::logarithmic}};
    }
    require_same_units(file.layout.units, path, units, trajectories.front());
    longest = std::max(longest, add_points(file, panels));
  }
  if (!predictions.empty()) {
    const PlotInputs inputs = read_plot_inputs(predictions, choice);
    require_same_units(inputs.units, predictions.front(), units, trajectories.front());
    if (!inputs.runs.empty())
      throw InputError(inputs.runs.front().source, "this is a run record; give its trajectory (.h5md)");
    for (const PlottedPrediction& plotted : inputs.predictions) add_lines(plotted, longest, panels);
  }
  return {.title = "Diffusion of swimmers",
          .panels = std::move(panels),
          .notes = {{.text = "Points: means over swimmers and over times that do not overlap; bars: standard "
                             "errors."}},
          .has_common_legend = true};
}

}  // namespace

DrawFigure add_diffusion_flags(CLI::App& command) {
  const auto choice = std::make_shared<InputChoice>();
  add_method_flag(command, *choice);
  return [choice](const PlotFiles& files) { return draw(diffusion_figure(files.inputs, *choice)); };
}

}  // namespace beadswim
