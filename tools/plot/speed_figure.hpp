#pragma once

#include "beadswim/figure/figure.hpp"
#include "plot_inputs.hpp"

namespace beadswim {

struct SpeedFigureOptions {
  std::string reference;             ///< file of the run or prediction from which errors are measured
  std::vector<std::string> methods;  ///< of such a prediction; none: its best usable one
  CycleChoice cycle;
};

/// Errors of velocity and of stroke against core-seconds a period. Runs of one setting (model; bead boundary,
/// relaxation time, precision) are joined in order of their resolution; runs of one resolution too, as at
/// several places within a cell, are one point: rms of their errors, median of their costs. A faint line
/// joins the points than which none is both cheaper and more exact (Pareto's front), and a note names them;
/// the reference's own uncertainty is a level. Throws InputError for runs and references of different scenes,
/// for runs that differ in their corrections alone, and for such as do not say their cost.
Figure speed_figure(const PlotInputs& inputs, const SpeedFigureOptions& options);

}  // namespace beadswim
