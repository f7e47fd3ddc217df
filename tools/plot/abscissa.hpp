#pragma once

#include <optional>
#include <string>

#include "beadswim/core/names.hpp"
#include "beadswim/figure/figure.hpp"
#include "plot_inputs.hpp"

// Abscissas of figures that show runs and predictions.

namespace beadswim {

enum class Abscissa {
  period,            ///< driving period T [time]
  separation_ratio,  ///< separation ratio l/λ
  amplitude_ratio,   ///< ratio A/B of the driving amplitudes
  phase,             ///< driving phase α [rad]
};

/// Keys of the abscissas in the settings of a prediction.
template <>
inline constexpr auto name_table<Abscissa> =
    std::to_array<NamedValue<Abscissa>>({{Abscissa::period, "period"},
                                         {Abscissa::separation_ratio, "separation_ratio"},
                                         {Abscissa::amplitude_ratio, "amplitude_ratio"},
                                         {Abscissa::phase, "phase"}});

AxisLabel axis_label(Abscissa abscissa, const Units& units);

/// Returns the number, or the text, with this key in the settings of a prediction. Returns no value if there
/// is none.
std::optional<double> number_setting(const Prediction& prediction, const std::string& key);
std::optional<std::string> text_setting(const Prediction& prediction, const std::string& key);

/// Returns the abscissa of a prediction. Throws InputError if its settings do not contain the abscissa.
double abscissa_of(const PlottedPrediction& plotted, Abscissa abscissa);

/// Returns the abscissa of a swimmer in a run. The separation ratio is the smaller mean arm length in the
/// chosen cycles, divided by the smallest bead radius. Throws InputError if the run record does not contain
/// the abscissa. Records of models without a lattice do not contain the bead radius.
double abscissa_of(const PlottedRun& run, const SwimmerRecord& swimmer, Abscissa abscissa,
                   const CycleChoice& cycle);

struct PlacedPrediction {
  double x = 0;  ///< abscissa
  PlottedPrediction plotted;
};

/// Predictions by one method in order of the abscissa.
struct MethodPredictions {
  std::string method;
  std::vector<PlacedPrediction> predictions;
};

/// Returns the predictions of each method in inputs.methods, in this order. Throws InputError if a prediction
/// does not state its abscissa.
std::vector<MethodPredictions> predictions_by_method(const PlotInputs& inputs, Abscissa abscissa);

}  // namespace beadswim
