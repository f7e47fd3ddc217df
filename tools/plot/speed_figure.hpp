#pragma once

#include "beadswim/compare/figure.hpp"
#include "plot_inputs.hpp"

namespace beadswim {

struct SpeedFigureOptions {
  std::string reference;             ///< file of the run or prediction from which errors are measured
  std::vector<std::string> methods;  ///< of such a prediction; none: its best usable one
  CycleChoice cycle;
};

/// Periods of driving that a core does in an hour, against the error of velocity and of stroke. Runs of one
/// setting (bead boundary, relaxation time, precision) are joined in order of their resolution; runs of one
/// resolution too, as at several places within a cell, are one point: rms of their errors, median of their
/// speeds. Throws InputError for runs and references of different scenes, for runs that
/// differ in their corrections alone, and for such as do not say their cost.
Figure speed_figure(const PlotInputs& inputs, const SpeedFigureOptions& options);

}  // namespace beadswim
