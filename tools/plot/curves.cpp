#include "curves.hpp"

#include <algorithm>
#include <iterator>
#include <limits>

namespace beadswim {
namespace {

constexpr std::size_t most_marked_points = 12;

enum class Part { usable, not_usable, not_usable_with_neighbours };

bool belongs(const std::vector<CurvePoint>& points, std::size_t i, Part part) {
  if (part == Part::usable) return points[i].usable;
  const bool beside_unusable =
      (i > 0 && !points[i - 1].usable) || (i + 1 < points.size() && !points[i + 1].usable);
  return !points[i].usable || (part == Part::not_usable_with_neighbours && beside_unusable);
}

/// The points of one part of the curve; others are gaps.
Series part_of(const std::vector<CurvePoint>& points, Part part, Series style) {
  for (std::size_t i = 0; i < points.size(); ++i) {
    style.x.push_back(points[i].x);
    style.y.push_back(belongs(points, i, part) ? points[i].y : std::numeric_limits<double>::quiet_NaN());
  }
  return style;
}

Series faint(Series style, Mark mark) {
  style.label.clear();
  style.mark = mark;
  style.emphasis = Emphasis::faint;
  return style;
}

}  // namespace

std::vector<MethodPredictions> predictions_by_method(const PlotInputs& inputs, Abscissa abscissa) {
  std::vector<PlacedPrediction> sorted;
  for (const PlottedPrediction& plotted : inputs.predictions) {
    sorted.push_back({abscissa_of(plotted, abscissa), plotted});
  }
  std::stable_sort(sorted.begin(), sorted.end(), [](const auto& a, const auto& b) { return a.x < b.x; });
  std::vector<MethodPredictions> all;
  for (const std::string& method : inputs.methods) {
    all.push_back({method, {}});
    std::copy_if(sorted.begin(), sorted.end(), std::back_inserter(all.back().predictions),
                 [&](const PlacedPrediction& placed) { return placed.plotted.prediction.method == method; });
  }
  return all;
}

std::vector<Series> curve_series(const std::vector<CurvePoint>& points, const Series& given) {
  Series style = given;
  const bool marked = points.size() <= most_marked_points;
  style.mark = marked ? Mark::line_and_points : Mark::line;
  const auto is_usable = [](const CurvePoint& point) { return point.usable; };
  const auto usable = std::count_if(points.begin(), points.end(), is_usable);
  if (usable == static_cast<std::ptrdiff_t>(points.size())) return {part_of(points, Part::usable, style)};
  if (usable == 0) {
    style.emphasis = Emphasis::faint;
    return {part_of(points, Part::not_usable, style)};
  }
  std::vector<Series> series{part_of(points, Part::not_usable_with_neighbours, faint(style, Mark::line)),
                             part_of(points, Part::usable, style)};
  if (marked) series.push_back(part_of(points, Part::not_usable, faint(style, Mark::points)));
  return series;
}

int method_shape(std::size_t position) {
  constexpr int first_open_shape = 4;
  return first_open_shape + static_cast<int>(position % 4);
}

}  // namespace beadswim
