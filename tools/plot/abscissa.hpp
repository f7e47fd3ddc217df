#pragma once

#include <optional>
#include <string>

#include "beadswim/core/names.hpp"
#include "beadswim/figure/figure.hpp"
#include "plot_inputs.hpp"

// What theory's curves and runs are drawn against.

namespace beadswim {

enum class Abscissa {
  period,            ///< T of the driving [time]
  separation_ratio,  ///< l/lambda, of the closest neighbours
  amplitude_ratio,   ///< A/B of the driving forces
  phase,             ///< alpha between them [radian]
};

/// Their keys in the settings of a prediction.
template <>
inline constexpr auto name_table<Abscissa> =
    std::to_array<NamedValue<Abscissa>>({{Abscissa::period, "period"},
                                         {Abscissa::separation_ratio, "separation_ratio"},
                                         {Abscissa::amplitude_ratio, "amplitude_ratio"},
                                         {Abscissa::phase, "phase"}});

AxisLabel axis_label(Abscissa abscissa, const Units& units);

/// A number or a text among the prediction's settings, if it is there.
std::optional<double> number_setting(const Prediction& prediction, const std::string& key);
std::optional<std::string> text_setting(const Prediction& prediction, const std::string& key);

/// Throws InputError, naming source and key, if the settings lack it.
double abscissa_of(const PlottedPrediction& plotted, Abscissa abscissa);

/// Of a run: the period; or the separation, from the smaller mean arm in these cycles and the radius of the
/// smallest bead. Throws InputError for what a run record does not say: all else, and the radius of beads
/// without a lattice.
double abscissa_of(const PlottedRun& run, const SwimmerRecord& swimmer, Abscissa abscissa,
                   const CycleChoice& cycle);

struct PlacedPrediction {
  double x = 0;  ///< its abscissa
  PlottedPrediction plotted;
};

/// A method's predictions in order of the abscissa.
struct MethodPredictions {
  std::string method;
  std::vector<PlacedPrediction> predictions;
};

/// In the order of inputs.methods. Throws InputError if a prediction does not say its abscissa.
std::vector<MethodPredictions> predictions_by_method(const PlotInputs& inputs, Abscissa abscissa);

}  // namespace beadswim
