#pragma once

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "result_series.hpp"

// Labels and notes of figures that show runs and predictions.

namespace beadswim {

/// Returns a label for each run: model, and all settings (bead boundary, resolution, relaxation time,
/// precision and box) that differ between runs: "lbm mr, 4 cells per radius".
std::vector<std::string> setting_labels(const std::vector<RunFile>& runs);

/// Returns a note that states the parameters of all runs, with ranges where they differ: "Runs: T = 1000 to
/// 10000, ...". Omits the parameter on the horizontal axis, and settings that differ between runs, because
/// the labels of the runs state these settings. Returns an empty note if there is no run.
Note run_note(const PlotInputs& inputs, std::optional<AbscissaKind> abscissa);

/// Returns a note that explains marks (runs) and lines (predictions) of the figure.
Note reading_note(const PlotInputs& inputs);

/// Returns the notes of a figure against a quantity that is not of a study: reading_note(), the parameters of
/// the predictions, with ranges where they differ, "Predictions: T = 4800, A/B = 1", without the quantity and
/// what a prediction does not state, what is said of predictions that are not usable, and run_note().
std::vector<Note> notes_against(const PlotInputs& inputs, AbscissaKind abscissa);

/// Returns the names joined by commas, or their number if there are more than three, for example "5 methods".
/// `plural`: the word after the number.
std::string summarise_names(const std::set<std::string>& names, const std::string& plural);

/// Returns a number of cycles, a range of it, and the noun: "1 cycle", "0.5 to 4 cycles".
std::string cycles_text(const std::vector<double>& cycles);

/// Returns the range of the numbers, for example "4800" or "1000 to 10000". `digits`: number of significant
/// digits.
std::string range_text(const std::vector<double>& numbers, int digits);

}  // namespace beadswim
