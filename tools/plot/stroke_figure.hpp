#pragma once

#include "beadswim/compare/figure.hpp"
#include "plot_inputs.hpp"

namespace beadswim {

/// Arm amplitudes and sin(delta1 - delta2) cycle by cycle: runs as points (all their swimmers), predictions
/// as level lines. Throws InputError without a run that holds a whole cycle.
Figure stroke_figure(const PlotInputs& inputs);

}  // namespace beadswim
