#pragma once

#include <optional>
#include <string>

#include "beadswim/core/names.hpp"
#include "beadswim/figure/figure.hpp"
#include "plot_inputs.hpp"

// Quantities on the horizontal axis of figures that show runs and predictions.

namespace beadswim {

enum class Abscissa {
  period,            ///< driving period T [time]
  separation_ratio,  ///< separation ratio l/λ
  amplitude_ratio,   ///< ratio A/B of the driving amplitudes
  phase,             ///< driving phase α [rad]
};

/// Keys under which the settings of a prediction contain these quantities.
template <>
inline constexpr auto name_table<Abscissa> =
    std::to_array<NamedValue<Abscissa>>({{Abscissa::period, "period"},
                                         {Abscissa::separation_ratio, "separation_ratio"},
                                         {Abscissa::amplitude_ratio, "amplitude_ratio"},
                                         {Abscissa::phase, "phase"}});

AxisLabel axis_label(Abscissa abscissa, const Units& units);

/// Returns the text with this key in the settings of a prediction; nullopt if there is none.
std::optional<std::string> text_setting(const Prediction& prediction, const std::string& key);

/// Returns the value on the horizontal axis for a prediction. Throws InputError if the settings of the
/// prediction do not contain this quantity.
double abscissa_of(const PlottedPrediction& plotted, Abscissa abscissa);

/// Returns the value on the horizontal axis for a swimmer in a run. The separation ratio is the smaller mean
/// arm length in the chosen cycles, divided by the smallest bead radius. Throws InputError if the run record
/// does not contain the quantity. Records of models without a lattice do not contain the bead radius.
double abscissa_of(const PlottedRun& run, const SwimmerRecord& swimmer, Abscissa abscissa,
                   const CycleChoice& cycle);

struct PlacedPrediction {
  double x = 0;  ///< abscissa
  PlottedPrediction plotted;
};

/// Predictions by one method, sorted by the value on the horizontal axis.
struct MethodPredictions {
  std::string method;
  std::vector<PlacedPrediction> predictions;
};

/// Returns the predictions of each method in inputs.methods, in this order. Throws InputError if the settings
/// of a prediction do not contain the quantity on the horizontal axis.
std::vector<MethodPredictions> predictions_by_method(const PlotInputs& inputs, Abscissa abscissa);

}  // namespace beadswim
