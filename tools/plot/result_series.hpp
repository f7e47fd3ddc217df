#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "beadswim/core/names.hpp"
#include "beadswim/documents/results.hpp"
#include "beadswim/figure/curves.hpp"
#include "plot_inputs.hpp"

// Results of runs (marks) and predictions (lines) against a quantity: the series of all such figures.

namespace beadswim {

/// Quantities on the horizontal axis.
enum class AbscissaKind {
  period,            ///< driving period T [time]
  separation_ratio,  ///< separation ratio l/λ
  amplitude_ratio,   ///< ratio A/B of the driving amplitudes
  phase,             ///< driving phase α [rad]
  study,             ///< quantity that beadswim-layout vary has varied
};

/// All but the last are the keys under which the settings of a prediction contain these quantities.
template <>
inline constexpr auto name_table<AbscissaKind> =
    std::to_array<NamedValue<AbscissaKind>>({{AbscissaKind::period, "period"},
                                             {AbscissaKind::separation_ratio, "separation_ratio"},
                                             {AbscissaKind::amplitude_ratio, "amplitude_ratio"},
                                             {AbscissaKind::phase, "phase"},
                                             {AbscissaKind::study, "study"}});

struct Abscissa {
  AbscissaKind kind = AbscissaKind::study;
  std::string study{};  ///< name of the quantity of the study
};

AxisLabel axis_label(const Abscissa& abscissa, const Units& units);
AxisLabel result_label(ResultQuantity quantity, const Units& units);

/// Returns the value of a quantity of a study as a number. Throws InputError if the document has no such
/// quantity, or if it is a word. `flag`: flag that names the quantity, for the message.
double number_in_study(const Json& study, const std::string& name, const std::string& source,
                       const std::string& flag);

/// Returns the value on the horizontal axis for a prediction. Throws InputError if its settings, or its
/// study, do not contain this quantity.
double abscissa_of(const PlottedPrediction& plotted, const Abscissa& abscissa);

/// Results of one swimmer of a run, or of one prediction, at a place on the horizontal axis.
struct ResultPoint {
  double x = 0;
  Results results;
  bool usable = true;
  std::string source;
  Json study{};
};

/// Points that are drawn alike.
struct ResultSeries {
  std::string label;
  std::vector<ResultPoint> points{};
};

struct DrawnResults {
  std::vector<ResultSeries> runs, predictions;
  std::optional<std::pair<double, double>> level{};  ///< ends of the levels of predictions; nullopt: curves
};

/// Values of `group_by` below that are no quantities of a study.
inline constexpr const char *by_swimmer = "swimmer", *by_type = "type";

/// Replaces points of runs that differ only in the quantity `name` of the study by their mean, with its
/// standard error; of predictions, by the first. Throws InputError if no study has the quantity.
void average_over(const std::string& name, const PlotInputs& inputs, DrawnResults& drawn);

/// Returns series of runs of one setting, with means over the chosen cycles, and of predictions by one
/// method. The values of the quantity `group_by` of the study, unless it is empty, have separate series; so
/// have the swimmers, by_swimmer, and their types, by_type, of which runs have one point: the mean. The
/// separation ratio of a run is the smaller mean arm length, divided by the smallest bead radius. Throws
/// InputError if an input lacks the abscissa or the quantity `group_by`.
DrawnResults results_against(const PlotInputs& inputs, const Abscissa& abscissa, const CycleChoice& cycle,
                             const std::string& group_by = "");

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
