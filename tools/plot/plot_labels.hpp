#pragma once

#include <string>
#include <vector>

#include "abscissa.hpp"
#include "plot_inputs.hpp"

// What figures say in words.

namespace beadswim {

/// "lbm", or "lbm FILE" where several runs must be told apart.
std::string run_label(const PlotInputs& inputs, const PlottedRun& run);

/// A line on each run: what it is of and how it was resolved.
std::vector<std::string> run_notes(const PlotInputs& inputs);

/// Runs of one model, bead boundary, resolution, relaxation time, precision and box.
struct RunGroup {
  std::string label;  ///< "lbm", and what sets it apart from the other groups: "lbm mr, 4 cells per radius"
  std::vector<const PlottedRun*> runs;  ///< of the inputs
};

/// In the order of their first runs.
std::vector<RunGroup> runs_by_setting(const PlotInputs& inputs);

/// A line on each group, with the ranges of its runs.
std::vector<std::string> group_notes(const std::vector<RunGroup>& groups);

/// What all predictions were made for, but for the abscissa: "Predictions: T = 4800, A/B = 1"; a second line
/// if some are marked unusable. Parameters that a prediction does not say are left out.
std::vector<std::string> prediction_notes(const PlotInputs& inputs, Abscissa abscissa);

}  // namespace beadswim
