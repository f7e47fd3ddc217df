#include "beadswim/figure/error_figure.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>

#include "beadswim/core/error.hpp"

namespace beadswim {
namespace {

constexpr int black = 6;  // index in the palette

// A string, not a literal: for literals GCC 12 reports a memcpy out of bounds (-Warray-bounds), which is
// wrong.
const std::string front_text = "On the front, no other run is both cheaper and more accurate.";

/// Returns true if logarithmic axes can show the point.
bool is_plottable(const ErrorPoint& point) {
  return point.error > 0 && std::isfinite(point.error) && point.cost > 0 && std::isfinite(point.cost);
}

/// Removes the points that logarithmic axes cannot show, and returns their number. Throws InputError if no
/// point remains.
std::size_t remove_unplottable(QuantityErrors& errors, const std::string& cost) {
  std::vector<ErrorPoint> removed;
  std::size_t kept = 0;
  for (ErrorSeries& series : errors.series) {
    std::ranges::copy_if(series.points, std::back_inserter(removed), std::not_fn(is_plottable));
    std::erase_if(series.points, std::not_fn(is_plottable));
    kept += series.points.size();
  }
  if (kept > 0 || removed.empty()) return removed.size();
  const ErrorPoint& point = removed.front();
  throw InputError(
      point.source,
      fmt::format("the run has an error of {:g} in the {} and a cost of {:g} {}, but a logarithmic axis "
                  "needs positive finite numbers; leave this file out if it is the reference itself, or draw "
                  "another quantity",
                  point.error, errors.quantity, point.cost, cost));
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

/// Adds a panel, and a note that names the most accurate point and counts what is not drawn. `labels`: labels
/// of all series, in the order of their styles.
void add_panel(QuantityErrors errors, const std::string& cost, const std::vector<std::string>& labels,
               Figure& figure) {
  const std::size_t removed = remove_unplottable(errors, cost);
  Panel panel{.x_label = {cost, "s"},
              .y_label = {"error of the " + errors.quantity, "%"},
              .x_scale = ScaleKind::logarithmic,
              .y_scale = ScaleKind::logarithmic,
              .title = errors.scene};
  std::vector<ErrorPoint> points;
  for (const ErrorSeries& one : errors.series) {
    if (one.points.empty()) continue;
    const auto position = static_cast<int>(std::ranges::find(labels, one.label) - labels.begin());
    panel.series.push_back(with_points(one.points, {.label = one.label,
                                                    .mark = Mark::line_and_points,
                                                    .colour = position,
                                                    .shape = position,
                                                    .dash = position}));
    points.insert(points.end(), one.points.begin(), one.points.end());
  }
  const double uncertainty = errors.uncertainty.value_or(0);
  const std::vector<ErrorPoint> front = pareto_front(points, uncertainty);
  panel.series.push_back(with_points(
      front, {.label = "front", .mark = Mark::line, .colour = black, .emphasis = Emphasis::faint}));
  if (errors.uncertainty) {
    auto [cheapest, costliest] = std::ranges::minmax(points, {}, &ErrorPoint::cost);
    cheapest.error = costliest.error = uncertainty;
    panel.series.push_back(with_points({cheapest, costliest}, {.label = "uncertainty of the reference",
                                                               .mark = Mark::line,
                                                               .colour = black,
                                                               .dash = 1,
                                                               .emphasis = Emphasis::faint}));
  }
  figure.panels.push_back(std::move(panel));
  figure.notes.push_back(
      {.text = fmt::format("{}{}{}: {}{}.", errors.scene.empty() ? "" : errors.scene + ": ",
                           front.back().error <= uncertainty
                               ? "Cheapest within the uncertainty of the reference, "
                               : "Most accurate ",
                           errors.quantity, front.back().name,
                           removed > 0 ? fmt::format("; not drawn for lack of an error: {}", removed) : "")});
}

}  // namespace

Figure error_figure(const std::vector<QuantityErrors>& quantities, const std::string& cost,
                    std::vector<Note> notes) {
  Figure figure{
      .title = "Speed against error", .panels = {}, .notes = std::move(notes), .has_common_legend = true};
  figure.notes.emplace_back(front_text);
  std::vector<std::string> labels;
  for (const QuantityErrors& errors : quantities) {
    for (const ErrorSeries& series : errors.series)
      if (std::ranges::find(labels, series.label) == labels.end()) labels.push_back(series.label);
  }
  for (const QuantityErrors& errors : quantities) add_panel(errors, cost, labels, figure);
  return figure;
}

}  // namespace beadswim
