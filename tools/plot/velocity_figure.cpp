#include "velocity_figure.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "beadswim/core/error.hpp"
#include "beadswim/scene/units.hpp"
#include "curves.hpp"
#include "plot_labels.hpp"
#include "relative_velocity.hpp"

namespace beadswim {
namespace {

bool is_relative(const PlotInputs& inputs) {
  return !inputs.references.empty();
}

void append_point(const PlotInputs& inputs, const VelocityFigureOptions& options, const PlottedRun& run,
                  const SwimmerRecord& swimmer, Series& series) {
  const double x = abscissa_of(run, swimmer, options.abscissa, options.cycle);
  const Swimming swimming = swimming_of(run.record, swimmer, options.cycle, run.source);
  const double velocity = swimming.at(ComparedQuantity::velocity).front();
  series.x.push_back(x);
  series.y.push_back(
      is_relative(inputs)
          ? relative_difference(velocity, reference_at(inputs, options.abscissa, x, run.source))
          : velocity);
}

std::vector<Series> run_series(const PlotInputs& inputs, const std::vector<RunGroup>& groups,
                               const VelocityFigureOptions& options) {
  if (is_relative(inputs) && options.abscissa != Abscissa::period && !inputs.runs.empty()) {
    throw InputError(inputs.runs.front().source,
                     "is a run, and runs are compared at equal period; leave it out, or --relative-to");
  }
  std::vector<Series> all;
  for (const RunGroup& group : groups) {
    const auto position = static_cast<int>(all.size());
    Series series{.label = group.label, .colour = position, .shape = position};
    for (const PlottedRun* run : group.runs) {
      for (const SwimmerRecord& swimmer : run->record.swimmers)
        append_point(inputs, options, *run, swimmer, series);
    }
    all.push_back(std::move(series));
  }
  return all;
}

CurvePoint curve_point(const PlotInputs& inputs, Abscissa abscissa, const PlacedPrediction& placed) {
  const auto& [x, plotted] = placed;
  const Prediction& prediction = plotted.prediction;
  if (!is_relative(inputs)) return {x, prediction.velocity, prediction.usable};
  const Prediction& reference = reference_at(inputs, abscissa, x, plotted.source);
  return {x, relative_difference(prediction.velocity, reference), prediction.usable && reference.usable};
}

/// Colours go on where those of the runs end.
std::vector<Series> prediction_series(const PlotInputs& inputs, Abscissa abscissa, int first_colour) {
  std::vector<Series> all;
  const auto methods = predictions_by_method(inputs, abscissa);
  for (std::size_t i = 0; i < methods.size(); ++i) {
    std::vector<CurvePoint> points;
    for (const PlacedPrediction& placed : methods[i].predictions) {
      points.push_back(curve_point(inputs, abscissa, placed));
    }
    const auto position = static_cast<int>(i);
    const auto curve = curve_series(points, {.label = methods[i].method,
                                             .colour = first_colour + position,
                                             .shape = method_shape(i),
                                             .dash = position});
    all.insert(all.end(), curve.begin(), curve.end());
  }
  return all;
}

/// Whether the values that shape the axis are positive and span over two decades.
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

Axes chosen_axes(const VelocityFigureOptions& options, const std::vector<Series>& all) {
  if (options.axes != Axes::automatic) return options.axes;
  if (!spans_decades(all)) return Axes::linear;
  return options.abscissa == Abscissa::separation_ratio ? Axes::log_log : Axes::log_y;
}

/// What a logarithmic axis has no place for must not go unsaid.
void note_what_is_missing(const Panel& panel, std::vector<std::string>& notes) {
  if (panel.y_scale == ScaleKind::linear) return;
  const auto is_missing = [](double value) { return value <= 0; };
  const auto lacks_some = [&](const Series& series) {
    return std::any_of(series.y.begin(), series.y.end(), is_missing);
  };
  if (std::none_of(panel.series.begin(), panel.series.end(), lacks_some)) return;
  notes.push_back("Lines break where the velocity is not positive: the axis is logarithmic");
}

std::string title_of(const PlotInputs& inputs, Abscissa abscissa) {
  const std::string against = abscissa == Abscissa::period ? "driving period" : "separation of the beads";
  if (!is_relative(inputs)) return "Swimming velocity against " + against;
  return fmt::format("Swimming velocity relative to {}, against {}",
                     inputs.references.front().prediction.method, against);
}

AxisLabel velocity_label(const PlotInputs& inputs) {
  if (!is_relative(inputs)) return {"velocity", velocity_unit(inputs.units)};
  return {"difference in velocity", "%"};
}

}  // namespace

Figure velocity_figure(const PlotInputs& inputs, const VelocityFigureOptions& options) {
  const std::vector<RunGroup> groups = runs_by_setting(inputs);
  std::vector<Series> series = run_series(inputs, groups, options);
  const auto curves = prediction_series(inputs, options.abscissa, static_cast<int>(series.size()));
  series.insert(series.end(), curves.begin(), curves.end());
  const Axes axes = chosen_axes(options, series);
  Panel panel{.x_label = axis_label(options.abscissa, inputs.units),
              .y_label = velocity_label(inputs),
              .series = std::move(series),
              .x_scale = axes == Axes::log_log ? ScaleKind::logarithmic : ScaleKind::linear,
              .y_scale = axes == Axes::linear ? ScaleKind::linear : ScaleKind::logarithmic};
  std::vector<std::string> notes = prediction_notes(inputs, options.abscissa);
  note_what_is_missing(panel, notes);
  const auto more = group_notes(groups);
  notes.insert(notes.end(), more.begin(), more.end());
  return {.title = title_of(inputs, options.abscissa), .panels = {std::move(panel)}, .notes = notes};
}

}  // namespace beadswim
