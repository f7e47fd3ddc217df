#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>

#include "beadswim/core/error.hpp"
#include "errors.hpp"

namespace beadswim {
namespace {

constexpr int black = 6;  // index in the palette

// A string, not a literal: for literals GCC 12 reports a memcpy out of bounds (-Warray-bounds), which is
// wrong.
const std::string front_text = "On the front, no other run is both cheaper and more accurate.";

/// Error and cost of the runs of one resolution.
struct ErrorPoint {
  std::string name;    ///< name of the runs in a note
  std::string source;  ///< file of the first run, for error messages
  double cost = 0;     ///< [s]
  double error = 0;    ///< relative error
};

/// Returns true if logarithmic axes can show the point.
bool is_plottable(const ErrorPoint& point) {
  return point.error > 0 && std::isfinite(point.error) && point.cost > 0 && std::isfinite(point.cost);
}

/// Returns the Pareto front in order of increasing cost: each of its points has a smaller error than all
/// cheaper points. Errors below `uncertainty`, that of the reference, count as equal to it.
std::vector<ErrorPoint> pareto_front(std::vector<ErrorPoint> points, double uncertainty) {
  std::ranges::sort(points, {}, [](const ErrorPoint& p) { return std::pair(p.cost, p.error); });
  std::vector<ErrorPoint> front;
  for (const ErrorPoint& point : points) {
    if (!front.empty() && front.back().error <= uncertainty) break;
    if (front.empty() || point.error < front.back().error) front.push_back(point);
  }
  return front;
}

/// Returns a series of this style through the points, with errors in percent.
Series with_points(const std::vector<ErrorPoint>& points, Series style) {
  for (const ErrorPoint& point : points) {
    style.x.push_back(point.cost);
    style.y.push_back(100 * point.error);
  }
  return style;
}

/// Returns the errors of a quantity for a setting.
std::vector<ErrorPoint> points_of(const ErrorsOfSetting& errors, ResultQuantity quantity) {
  std::vector<ErrorPoint> points;
  for (const auto& [cells, source, cost, known] : errors.resolutions) {
    if (!known.contains(quantity)) continue;
    const std::string name =
        cells > 0 ? fmt::format("{}, {:g} cells", errors.setting, cells) : errors.setting;
    points.push_back({name, source, cost, known.at(quantity)});
  }
  return points;
}

/// Adds the panel of a quantity, and a note that names the most accurate point and counts what is not drawn.
/// Adds nothing if no error is known. `labels`: labels of all series, in the order of their styles.
void add_panel(const SceneErrors& errors, ResultQuantity quantity, const std::string& quantity_name,
               const std::string& cost, std::vector<std::string>& labels, Figure& figure) {
  Panel panel{.x_label = {cost, "s"},
              .y_label = {"error of the " + quantity_name, "%"},
              .x_scale = ScaleKind::logarithmic,
              .y_scale = ScaleKind::logarithmic,
              .title = errors.title};
  std::vector<ErrorPoint> drawn, removed;
  for (const ErrorsOfSetting& one : errors.settings) {
    std::vector<ErrorPoint> points = points_of(one, quantity);
    if (points.empty()) continue;
    const auto place = std::ranges::find(labels, one.setting);
    const auto position = static_cast<int>(place - labels.begin());
    if (place == labels.end()) labels.push_back(one.setting);
    std::ranges::copy_if(points, std::back_inserter(removed), std::not_fn(is_plottable));
    std::erase_if(points, std::not_fn(is_plottable));
    drawn.insert(drawn.end(), points.begin(), points.end());
    if (!points.empty())
      panel.series.push_back(with_points(points, {.label = one.setting,
                                                  .mark = Mark::line_and_points,
                                                  .colour = position,
                                                  .shape = position,
                                                  .dash = position}));
  }
  if (drawn.empty() && removed.empty()) return;
  if (drawn.empty())
    throw InputError(
        removed.front().source,
        "the run has an error of {:g} in the {} and a cost of {:g} {}, but a logarithmic axis needs positive "
        "finite numbers; leave this file out if it is the reference itself, or draw another quantity",
        removed.front().error, quantity_name, removed.front().cost, cost);
  const bool has_uncertainty = errors.uncertainties.contains(quantity);
  const double uncertainty = has_uncertainty ? errors.uncertainties.at(quantity) : 0;
  const std::vector<ErrorPoint> front = pareto_front(drawn, uncertainty);
  panel.series.push_back(with_points(
      front, {.label = "front", .mark = Mark::line, .colour = black, .emphasis = Emphasis::faint}));
  if (has_uncertainty) {
    auto [cheapest, costliest] = std::ranges::minmax(drawn, {}, &ErrorPoint::cost);
    cheapest.error = costliest.error = uncertainty;
    panel.series.push_back(with_points({cheapest, costliest}, {.label = "uncertainty of the reference",
                                                               .mark = Mark::line,
                                                               .colour = black,
                                                               .dash = 1,
                                                               .emphasis = Emphasis::faint}));
  }
  figure.panels.push_back(std::move(panel));
  figure.notes.push_back(
      {.text = fmt::format(
           "{}{}{}: {}{}.", errors.title.empty() ? "" : errors.title + ": ",
           front.back().error <= uncertainty ? "Cheapest within the uncertainty of the reference, "
                                             : "Most accurate ",
           quantity_name, front.back().name,
           removed.empty() ? "" : fmt::format("; not drawn for lack of an error: {}", removed.size()))});
}

}  // namespace

Figure error_figure(const std::vector<SceneErrors>& scenes, std::optional<ResultQuantity> only,
                    const std::string& cost, std::vector<Note> notes) {
  Figure figure{
      .title = "Speed against error", .panels = {}, .notes = std::move(notes), .has_common_legend = true};
  figure.notes.emplace_back(front_text);
  std::vector<std::string> labels;
  for (const SceneErrors& errors : scenes)
    for (const auto& [quantity, name] : {std::pair(ResultQuantity::velocity, "velocity"),
                                         std::pair(ResultQuantity::arm_amplitudes, "arm amplitudes")})
      if (only.value_or(quantity) == quantity) add_panel(errors, quantity, name, cost, labels, figure);
  return figure;
}

}  // namespace beadswim
