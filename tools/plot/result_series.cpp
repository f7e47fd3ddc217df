#include "result_series.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "beadswim/documents/study_text.hpp"
#include "plot_labels.hpp"

namespace beadswim {
namespace {

/// Returns the smallest number of digits, at least 4, with which the values of a quantity of the study have
/// different texts.
int study_digits(const PlotInputs& inputs, const std::string& name) {
  std::set<double> values;
  for (const Json& study : studies_of(inputs))
    if (study.contains(name) && study[name].is_number()) values.insert(study[name].get<double>());
  for (int digits = 4; digits < 17; ++digits) {
    std::set<std::string> texts;
    for (const double value : values) texts.insert(fmt::format("{:.{}g}", value, digits));
    if (texts.size() == values.size()) return digits;
  }
  return 17;
}

/// Makes the series of the inputs. A series holds points of one group of --group-by.
class SeriesMaker {
 public:
  SeriesMaker(const PlotInputs& inputs, const SeriesSettings& settings)
      : inputs_(inputs), settings_(settings), digits_(study_digits(inputs, settings.group_by)) {}

  std::vector<ResultSeries> of_runs() {
    for (const RunGroup& group : runs_by_setting(inputs_)) {
      first_ = all_.size();
      for (const PlottedRun* run : group.runs)
        for (const SwimmerRecord& swimmer : run->record.swimmers)
          add(group.label, study_of(*run),
              {abscissa_of(*run, swimmer, settings_.abscissa, settings_.cycle),
               results_of(run->record, swimmer, settings_.cycle, run->source), true, run->source});
    }
    return std::move(all_);
  }

  std::vector<ResultSeries> of_predictions() {
    for (const std::string& method : inputs_.methods) {
      first_ = all_.size();
      for (const PlottedPrediction& plotted : inputs_.predictions)
        if (plotted.prediction.method == method)
          add(method, plotted.study,
              {abscissa_of(plotted, settings_.abscissa), results_of(plotted), plotted.prediction.usable,
               plotted.source});
    }
    for (ResultSeries& series : all_) std::ranges::stable_sort(series.points, {}, &ResultPoint::x);
    return std::move(all_);
  }

 private:
  /// Adds a point to the series from number first_ on that has its label, or to a new one.
  void add(std::string label, const Json& study, ResultPoint point) {
    const std::string& name = settings_.group_by;
    if (!name.empty())
      label += fmt::format(", {} = {}", name,
                           study_value_text(study_value(study, name, point.source, "--group-by"), digits_));
    auto found = std::find_if(all_.begin() + static_cast<std::ptrdiff_t>(first_), all_.end(),
                              [&](const ResultSeries& series) { return series.label == label; });
    if (found == all_.end()) found = all_.insert(found, ResultSeries{label});
    found->points.push_back(std::move(point));
  }

  const PlotInputs& inputs_;
  const SeriesSettings& settings_;
  const int digits_;
  std::size_t first_ = 0;
  std::vector<ResultSeries> all_{};
};

/// Returns a point for each swimmer of a run in each cycle. Uncertainties belong to the last one.
ResultSeries series_by_cycle(const PlotInputs& inputs, const PlottedRun& run) {
  ResultSeries series{run_label(inputs, run)};
  for (const SwimmerRecord& swimmer : run.record.swimmers) {
    for (const CycleStatistics& cycle : swimmer.cycles) {
      CycleChoice choice;
      if (&cycle != &swimmer.cycles.back()) choice = {CycleChoice::Kind::index, cycle.index};
      series.points.push_back({static_cast<double>(cycle.index),
                               results_of(run.record, swimmer, choice, run.source), true, run.source});
    }
  }
  return series;
}

/// Returns the points of a series that have the number; with a fixed colour, NaN for the others.
std::vector<CurvePoint> points_of(const ResultSeries& series, const DrawnNumber& drawn,
                                  const Relation& relation) {
  std::vector<CurvePoint> points;
  for (const ResultPoint& point : series.points) {
    const auto found = point.results.find(drawn.quantity);
    if (found != point.results.end() && drawn.number < found->second.numbers.size()) {
      const ResultValue& value = found->second;
      points.push_back({point.x, value.numbers[drawn.number], point.usable, value.error(drawn.number)});
      if (relation) points.back() = relation(point, points.back());
    } else if (drawn.colour) {
      points.push_back({.x = point.x, .y = NAN, .usable = point.usable});
    }
  }
  return points;
}

std::vector<Curve> curves_of(const std::vector<ResultSeries>& all, const std::vector<DrawnNumber>& numbers,
                             const Relation& relation) {
  std::vector<Curve> curves;
  for (const ResultSeries& series : all)
    for (const DrawnNumber& drawn : numbers)
      if (std::vector<CurvePoint> points = points_of(series, drawn, relation); !points.empty())
        curves.push_back({drawn.before + series.label + drawn.after, std::move(points)});
  return curves;
}

}  // namespace

DrawnResults results_against(const PlotInputs& inputs, const SeriesSettings& settings) {
  SeriesMaker runs(inputs, settings), predictions(inputs, settings);
  return {.runs = runs.of_runs(), .predictions = predictions.of_predictions()};
}

DrawnResults results_by_cycle(const PlotInputs& inputs) {
  constexpr double overhang = 0.4;  // [cycles]
  DrawnResults drawn{.runs = {}, .predictions = {}};
  std::vector<double> cycles;
  for (const PlottedRun& run : inputs.runs) {
    drawn.runs.push_back(series_by_cycle(inputs, run));
    for (const ResultPoint& point : drawn.runs.back().points) cycles.push_back(point.x);
  }
  for (const PlottedPrediction& plotted : inputs.predictions)
    drawn.predictions.push_back({plotted.prediction.method + varied_text(inputs, plotted.study),
                                 {{0, results_of(plotted), plotted.prediction.usable, plotted.source}}});
  if (!cycles.empty())
    drawn.level = {std::ranges::min(cycles) - overhang, std::ranges::max(cycles) + overhang};
  return drawn;
}

std::size_t max_numbers(const DrawnResults& drawn, ResultQuantity quantity) {
  std::size_t numbers = 0;
  for (const auto* all : {&drawn.runs, &drawn.predictions})
    for (const ResultSeries& series : *all)
      for (const ResultPoint& point : series.points)
        if (const auto found = point.results.find(quantity); found != point.results.end())
          numbers = std::max(numbers, found->second.numbers.size());
  return numbers;
}

void append(const DrawnResults& drawn, const std::vector<DrawnNumber>& numbers, Panel& panel,
            const Relation& relation) {
  const std::optional<int> colour = numbers.empty() ? std::nullopt : numbers.front().colour;
  const std::vector<Curve> marks = curves_of(drawn.runs, numbers, relation);
  const std::vector<Curve> curves = curves_of(drawn.predictions, numbers, relation);
  append_marks_and_curves(marks, drawn.level ? std::vector<Curve>() : curves, colour, panel);
  if (!drawn.level) return;
  std::vector<Level> levels;
  for (const auto& [label, points] : curves) levels.push_back({label, points[0].y, points[0].error});
  append_levels(levels, drawn.level->first, drawn.level->second, colour.value_or(0), panel);
}

}  // namespace beadswim
