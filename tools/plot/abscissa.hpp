#pragma once

#include <optional>
#include <string>

#include "beadswim/core/names.hpp"
#include "beadswim/figure/figure.hpp"
#include "plot_inputs.hpp"

// Quantities on the horizontal axis of figures that show runs and predictions.

namespace beadswim {

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
/// Returns the label of a quantity of the study.
AxisLabel study_label(const std::string& name, const Units& units);

/// Returns the text with this key in the settings of a prediction; nullopt if there is none.
std::optional<std::string> text_setting(const Prediction& prediction, const std::string& key);

/// Returns the value of a quantity of a study. Throws InputError if the document has no such quantity.
/// `flag`: flag that names the quantity, for the message.
Json study_value(const Json& study, const std::string& name, const std::string& source,
                 const std::string& flag);
/// As above for a number; throws InputError for a word.
double number_in_study(const Json& study, const std::string& name, const std::string& source,
                       const std::string& flag);

/// Returns the value on the horizontal axis for a prediction. Throws InputError if its settings, or its
/// study, do not contain this quantity.
double abscissa_of(const PlottedPrediction& plotted, const Abscissa& abscissa);

/// Returns the value on the horizontal axis for a swimmer in a run. The separation ratio is the smaller mean
/// arm length in the chosen cycles, divided by the smallest bead radius. Throws InputError if the run record
/// does not contain the quantity.
double abscissa_of(const PlottedRun& run, const SwimmerRecord& swimmer, const Abscissa& abscissa,
                   const CycleChoice& cycle);

}  // namespace beadswim
