#pragma once

#include "beadswim/compare/figure.hpp"
#include "plot_inputs.hpp"

namespace beadswim {

/// Velocity along the axis, against the fluid, over the driving's period: runs as points, one series a model;
/// predictions joined in order of period, one series a method.
Figure velocity_figure(const PlotInputs& inputs, const CycleChoice& cycle);

}  // namespace beadswim
