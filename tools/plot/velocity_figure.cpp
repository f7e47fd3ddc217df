#include "velocity_figure.hpp"

#include <algorithm>
#include <utility>

namespace beadswim {
namespace {

/// The series of that label, begun at the end of the list if there is none yet.
Series& series_labelled(const std::string& label, std::vector<Series>& all) {
  const auto found =
      std::find_if(all.begin(), all.end(), [&](const Series& series) { return series.label == label; });
  if (found != all.end()) return *found;
  all.push_back({.label = label});
  return all.back();
}

std::vector<Series> run_series(const PlotInputs& inputs, const CycleChoice& cycle) {
  std::vector<Series> all;
  for (const PlottedRun& run : inputs.runs) {
    Series& series = series_labelled(run.record.model, all);
    for (const SwimmerRecord& swimmer : run.record.swimmers) {
      const Swimming swimming = swimming_of(run.record, swimmer, cycle, run.source);
      series.x.push_back(run.record.driving_period);
      series.y.push_back(swimming.at(ComparedQuantity::velocity).front());
    }
  }
  return all;
}

std::vector<Series> prediction_series(const PlotInputs& inputs) {
  std::vector<PlottedPrediction> by_period = inputs.predictions;
  std::stable_sort(by_period.begin(), by_period.end(),
                   [](const auto& a, const auto& b) { return a.period < b.period; });
  std::vector<Series> all;
  for (const PlottedPrediction& plotted : by_period) {
    Series& series = series_labelled(plotted.prediction.method, all);
    series.x.push_back(plotted.period);
    series.y.push_back(plotted.prediction.velocity);
  }
  return all;
}

/// Open points tell predictions from runs, and where between the lines a prediction was made.
void style(std::vector<Series>& runs, std::vector<Series>& predictions) {
  constexpr int first_open_shape = 4;
  int colour = 0;
  for (Series& series : runs) {
    series.shape = series.colour = colour++;
  }
  for (std::size_t i = 0; i < predictions.size(); ++i) {
    predictions[i].mark = Mark::line_and_points;
    predictions[i].colour = colour++;
    predictions[i].shape = first_open_shape + static_cast<int>(i);
    predictions[i].dash = static_cast<int>(i);
  }
}

}  // namespace

Figure velocity_figure(const PlotInputs& inputs, const CycleChoice& cycle) {
  std::vector<Series> series = run_series(inputs, cycle);
  std::vector<Series> predictions = prediction_series(inputs);
  style(series, predictions);
  series.insert(series.end(), predictions.begin(), predictions.end());
  return {.title = "Swimming velocity against driving period",
          .panels = {{.x_label = {"period T", time_unit(inputs.units)},
                      .y_label = {"velocity", velocity_unit(inputs.units)},
                      .series = std::move(series)}},
          .notes = run_notes(inputs)};
}

}  // namespace beadswim
