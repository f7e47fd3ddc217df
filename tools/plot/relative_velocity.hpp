#pragma once

#include <string>

#include "abscissa.hpp"
#include "plot_inputs.hpp"

namespace beadswim {

/// The reference's prediction at that abscissa. Throws InputError naming `source`, whose velocity is to be
/// compared, if there is none or if there are several that differ.
const Prediction& reference_at(const PlotInputs& inputs, Abscissa abscissa, double x,
                               const std::string& source);

/// 100 (v / v_reference - 1), in percent.
double relative_difference(double velocity, const Prediction& reference);

}  // namespace beadswim
