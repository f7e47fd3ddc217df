#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "abscissa.hpp"
#include "beadswim/documents/results.hpp"
#include "beadswim/figure/curves.hpp"
#include "plot_inputs.hpp"

// Results of runs (marks) and predictions (lines) against a quantity: the series of all such figures.

namespace beadswim {

/// Results of one swimmer of a run, or of one prediction, at a place on the horizontal axis.
struct ResultPoint {
  double x = 0;
  Results results;
  bool usable = true;
  std::string source;
};

/// Points that are drawn alike.
struct ResultSeries {
  std::string label;
  std::vector<ResultPoint> points{};
};

struct SeriesSettings {
  Abscissa abscissa;
  CycleChoice cycle{};     ///< cycles of runs whose mean is drawn
  std::string group_by{};  ///< quantity of the study whose values have separate series; empty: none
};

struct DrawnResults {
  std::vector<ResultSeries> runs, predictions;
  std::optional<std::pair<double, double>> level{};  ///< ends of the levels of predictions; nullopt: curves
};

/// Returns series of runs of one setting, and of predictions by one method. Throws InputError if an input
/// lacks the abscissa or the quantity of `group_by`.
DrawnResults results_against(const PlotInputs& inputs, const SeriesSettings& settings);

/// Returns a series for each run, with all its cycles, and a level for each prediction.
DrawnResults results_by_cycle(const PlotInputs& inputs);

/// Returns the largest number of values of a quantity in one point.
std::size_t max_numbers(const DrawnResults& drawn, ResultQuantity quantity);

/// A number of a quantity on the vertical axis, and its style.
struct DrawnNumber {
  ResultQuantity quantity{};
  std::size_t number = 0;
  std::string before{}, after{};  ///< texts around the label of a series
  /// Index in the palette, for all series. Series that lack the number keep their place in the order of marks
  /// and dashes. nullopt: a colour per series that has the number
  std::optional<int> colour{};
};

/// Changes the value of a point, for example to a difference from a reference.
using Relation = std::function<CurvePoint(const ResultPoint&, CurvePoint)>;

/// Appends the series of numbers of equal colour to the panel.
void append(const DrawnResults& drawn, const std::vector<DrawnNumber>& numbers, Panel& panel,
            const Relation& relation = {});

}  // namespace beadswim
