#pragma once

#include "abscissa.hpp"
#include "beadswim/figure/figure.hpp"
#include "plot_inputs.hpp"

namespace beadswim {

/// Arm amplitudes and sin(delta1 - delta2) cycle by cycle: runs as points (all their swimmers), predictions
/// as level lines. Throws InputError without a run that holds a whole cycle.
Figure stroke_by_cycle(const PlotInputs& inputs);

/// The same against a parameter of the driving: predictions joined in order of it, one line style a method.
/// Throws InputError if a prediction does not say the parameter, and for runs, whose records do not.
Figure stroke_against(const PlotInputs& inputs, Abscissa abscissa, const CycleChoice& cycle);

}  // namespace beadswim
