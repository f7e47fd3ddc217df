#include "beadswim/figure/curves.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace beadswim {
namespace {

constexpr std::size_t max_marked_points = 12;

enum class Part { usable, not_usable, not_usable_with_neighbours };

bool belongs_to(const std::vector<CurvePoint>& points, std::size_t i, Part part) {
  if (part == Part::usable) return points[i].usable;
  const bool beside_unusable =
      (i > 0 && !points[i - 1].usable) || (i + 1 < points.size() && !points[i + 1].usable);
  return !points[i].usable || (part == Part::not_usable_with_neighbours && beside_unusable);
}

/// Returns the points of one part of a curve. y is NaN at all points that do not belong to the part, so that
/// the line has gaps there.
Series part_of(const std::vector<CurvePoint>& points, Part part, Series style) {
  const bool has_errors =
      std::ranges::any_of(points, [](const CurvePoint& point) { return point.error > 0; });
  for (std::size_t i = 0; i < points.size(); ++i) {
    style.x.push_back(points[i].x);
    style.y.push_back(belongs_to(points, i, part) ? points[i].y : std::numeric_limits<double>::quiet_NaN());
    if (has_errors) style.errors.push_back(points[i].error);
  }
  return style;
}

Series faint(Series style, Mark mark) {
  style.label = "";
  style.mark = mark;
  style.emphasis = Emphasis::faint;
  return style;
}

/// Returns the series that draw a curve: usable parts with Emphasis::plain, other parts with Emphasis::faint.
/// A curve with few points also has a marker at each point.
std::vector<Series> curve_series(const std::vector<CurvePoint>& points, Series style) {
  const bool marked = points.size() <= max_marked_points;
  style.mark = marked ? Mark::line_and_points : Mark::line;
  const auto is_usable = [](const CurvePoint& point) { return point.usable; };
  const auto usable = std::count_if(points.begin(), points.end(), is_usable);
  if (usable == static_cast<std::ptrdiff_t>(points.size())) return {part_of(points, Part::usable, style)};
  style.data_label = style.label + " (not usable)";
  if (usable == 0) {
    style.emphasis = Emphasis::faint;
    return {part_of(points, Part::not_usable, style)};
  }
  std::vector<Series> series{part_of(points, Part::not_usable_with_neighbours, faint(style, Mark::line)),
                             part_of(points, Part::usable, style)};
  series.back().data_label = "";
  if (marked) series.push_back(part_of(points, Part::not_usable, faint(style, Mark::points)));
  return series;
}

/// Returns true if the y values of all plain series are positive and span more than two decades.
bool spans_decades(const std::vector<Series>& all) {
  constexpr double two_decades = 100;
  double low = std::numeric_limits<double>::infinity(), high = 0;
  for (const Series& series : all) {
    if (series.emphasis == Emphasis::faint) continue;
    for (const double value : series.y) {
      if (!std::isfinite(value)) continue;
      low = std::min(low, value);
      high = std::max(high, value);
    }
  }
  return low > 0 && high > two_decades * low;
}

}  // namespace

void append_marks_and_curves(const std::vector<Curve>& marks, const std::vector<Curve>& curves,
                             std::optional<int> colour, Panel& panel) {
  const int num_marks = static_cast<int>(marks.size());
  for (int m = 0; m < num_marks; ++m) {
    const Curve& curve = marks[static_cast<std::size_t>(m)];
    panel.series.push_back(part_of(curve.points, Part::usable,
                                   {.label = curve.label, .colour = colour.value_or(m), .shape = m}));
  }
  constexpr int first_open_shape = 4;  // predictions have open markers, runs filled markers
  for (int c = 0; c < static_cast<int>(curves.size()); ++c) {
    const Curve& curve = curves[static_cast<std::size_t>(c)];
    std::ranges::move(curve_series(curve.points, {.label = curve.label,
                                                  .colour = colour.value_or(num_marks + c),
                                                  .shape = first_open_shape + c % 4,
                                                  .dash = c}),
                      std::back_inserter(panel.series));
  }
}

void append_levels(const std::vector<Curve>& levels, double from, double to, int colour, Panel& panel) {
  for (int l = 0; l < static_cast<int>(levels.size()); ++l) {
    const auto& [label, points] = levels[static_cast<std::size_t>(l)];
    const CurvePoint& level = points.front();
    const std::vector<CurvePoint> ends{{.x = from, .y = level.y, .error = level.error},
                                       {.x = to, .y = level.y, .error = level.error}};
    panel.series.push_back(
        part_of(ends, Part::usable, {.label = label, .mark = Mark::line, .colour = colour, .dash = l}));
  }
}

void set_axes(Axes axes, Axes logarithmic_axes, Panel& panel) {
  if (axes == Axes::automatic) axes = spans_decades(panel.series) ? logarithmic_axes : Axes::linear;
  panel.x_scale = axes == Axes::log_log ? ScaleKind::logarithmic : ScaleKind::linear;
  panel.y_scale = axes == Axes::linear ? ScaleKind::linear : ScaleKind::logarithmic;
}

bool has_omitted_values(const Panel& panel) {
  const auto lacks_some = [](const Series& series) {
    return std::ranges::any_of(series.y, [](double value) { return value <= 0; });
  };
  return panel.y_scale == ScaleKind::logarithmic && std::ranges::any_of(panel.series, lacks_some);
}

}  // namespace beadswim
