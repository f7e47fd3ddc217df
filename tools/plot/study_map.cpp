#include "study_map.hpp"

#include <fmt/core.h>

#include <cmath>
#include <iterator>
#include <map>
#include <set>

#include "beadswim/core/error.hpp"
#include "plot_labels.hpp"

namespace beadswim {
namespace {

using Point = std::pair<double, double>;

/// Values of a map at their points (x, y), one element per number of the result.
using MapValues = std::vector<std::map<Point, double>>;

/// Adds the values of a document. Throws InputError if there is a value at its point already.
void add_to_map(const Results& results, const Json& study, const MapSettings& settings,
                const std::string& source, MapValues& map) {
  const Point point{number_in_study(study, settings.x, source, "--x"),
                    number_in_study(study, settings.y, source, "--y")};
  const auto found = results.find(settings.colour);
  const std::size_t count = found == results.end() ? 0 : found->second.numbers.size();
  map.resize(std::max(map.size(), count));
  for (std::size_t i = 0; i < count; ++i) {
    if (map[i].emplace(point, found->second.numbers[i]).second) continue;
    throw InputError(source,
                     fmt::format("a second value for {} = {:g}, {} = {:g}; a map shows one value per point: "
                                 "name one method with --method, or files of one study and one model",
                                 settings.x, point.first, settings.y, point.second));
  }
}

/// Returns the edges between sorted places and beyond the first and the last, in the middle between
/// neighbours on an axis of this scale.
std::vector<double> edges_of(const std::set<double>& places, ScaleKind scale) {
  const bool is_log = scale == ScaleKind::logarithmic;
  std::vector<double> at, edges;
  for (const double place : places) at.push_back(is_log ? std::log(place) : place);
  const auto spacing = [&](std::size_t i) { return at.size() > 1 ? at[i + 1] - at[i] : 1; };
  edges.push_back(at.front() - spacing(0) / 2);
  for (std::size_t i = 0; i + 1 < at.size(); ++i) edges.push_back((at[i] + at[i + 1]) / 2);
  edges.push_back(at.back() + spacing(at.size() > 1 ? at.size() - 2 : 0) / 2);
  if (is_log)
    for (double& edge : edges) edge = std::exp(edge);
  return edges;
}

std::vector<MapCell> cells_of(const std::map<Point, double>& values, const Panel& panel) {
  std::set<double> xs, ys;
  for (const auto& [point, value] : values) {
    xs.insert(point.first);
    ys.insert(point.second);
  }
  const std::vector<double> x_edges = edges_of(xs, panel.x_scale), y_edges = edges_of(ys, panel.y_scale);
  std::vector<MapCell> cells;
  for (const auto& [point, value] : values) {
    if (!std::isfinite(value)) continue;
    const auto i = static_cast<std::size_t>(std::distance(xs.begin(), xs.find(point.first)));
    const auto j = static_cast<std::size_t>(std::distance(ys.begin(), ys.find(point.second)));
    cells.push_back({.x = point.first,
                     .y = point.second,
                     .value = value,
                     .x_low = x_edges[i],
                     .x_high = x_edges[i + 1],
                     .y_low = y_edges[j],
                     .y_high = y_edges[j + 1]});
  }
  return cells;
}

/// Throws InputError if a logarithmic axis would have places that are not positive.
void require_positive(const MapValues& map, const MapSettings& settings) {
  const bool log_x = settings.x_scale == ScaleKind::logarithmic;
  const bool log_y = settings.y_scale == ScaleKind::logarithmic;
  for (const auto& values : map)
    for (const auto& [point, value] : values)
      if ((log_x && point.first <= 0) || (log_y && point.second <= 0))
        throw InputError("--log", "a logarithmic axis needs values above 0; leave the flag out");
}

}  // namespace

Figure map_figure(const PlotInputs& inputs, const MapSettings& settings) {
  MapValues map;
  for (const PlottedRun& run : inputs.runs)
    add_to_map(results_of(run.record, run.record.swimmers.front(), settings.cycle, run.source), study_of(run),
               settings, run.source, map);
  for (const PlottedPrediction& plotted : inputs.predictions)
    add_to_map(results_of(plotted), plotted.study, settings, plotted.source, map);
  require_positive(map, settings);
  const auto [quantity, unit] = result_label(settings.colour, inputs.units);
  Figure figure{.title = capitalised(fmt::format("{} against {} and {}", quantity, settings.x, settings.y)),
                .panels = {},
                .notes = {}};
  for (std::size_t i = 0; i < map.size(); ++i) {
    Panel panel{.x_label = study_label(settings.x, inputs.units),
                .y_label = study_label(settings.y, inputs.units),
                .x_scale = settings.x_scale,
                .y_scale = settings.y_scale};
    const std::string symbol = arm_symbol(settings.colour, i);
    panel.value_label = {symbol.empty() ? quantity : symbol, unit};
    panel.cells = cells_of(map[i], panel);
    figure.panels.push_back(std::move(panel));
  }
  const std::string by = inputs.runs.empty() ? inputs.methods.front() : inputs.runs.front().record.model;
  figure.notes.push_back({.text = fmt::format("Each rectangle is one layout of the study, by {}.", by)});
  return figure;
}

}  // namespace beadswim
