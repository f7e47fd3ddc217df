#pragma once

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "abscissa.hpp"
#include "beadswim/figure/note.hpp"
#include "plot_inputs.hpp"

// Labels and notes of figures that show runs and predictions.

namespace beadswim {

/// Returns the label of a run: "lbm", or "lbm FILE" if there are several runs.
std::string run_label(const PlotInputs& inputs, const PlottedRun& run);

/// Runs with the same model, bead boundary, resolution, relaxation time, precision and box.
struct RunGroup {
  std::string label;  ///< model and all settings that differ between groups: "lbm mr, 4 cells per radius"
  std::vector<const PlottedRun*> runs;  ///< pointers into PlotInputs::runs
};

/// Returns the groups in the order of their first runs.
std::vector<RunGroup> runs_by_setting(const PlotInputs& inputs);

/// Returns a note on the parameters of all runs, with the ranges of numbers: "Runs: T = 1000 to 10000, ...".
/// Omits the parameter that is the abscissa, and settings that differ between runs, which labels contain.
/// Returns no text if there is no run.
Note run_note(const PlotInputs& inputs, std::optional<Abscissa> abscissa);

/// Returns notes on the predictions: their parameters except the abscissa, with the ranges of numbers, for
/// example "Predictions: T = 4800, A/B = 1"; and a second note if some predictions are not usable. Omits
/// parameters that a prediction does not state.
std::vector<Note> prediction_notes(const PlotInputs& inputs, Abscissa abscissa);

/// Returns a note on what the marks of runs and the lines of predictions show together.
Note reading_note(const PlotInputs& inputs);

/// Returns "a, b", or "5 methods" if there are more than three names. `plural` is "methods" here.
std::string summarise_names(const std::set<std::string>& names, const std::string& plural);

/// Returns the range of numbers with so many significant digits: "4800", or "1000 to 10000".
std::string range_text(const std::vector<double>& numbers, int digits);

}  // namespace beadswim
