#pragma once

#include <string>
#include <vector>

#include "beadswim/compare/cycle_choice.hpp"
#include "beadswim/documents/swimming_document.hpp"

// What figures are drawn from.

namespace beadswim {

struct PlottedRun {
  std::string source;
  RunRecord record;
};

/// One method of one prediction.
struct PlottedPrediction {
  std::string source;
  Prediction prediction;
  double period = 0;  ///< of the driving
};

/// All in the same units; each group in the order of the command line.
struct PlotInputs {
  Units units;
  std::vector<PlottedRun> runs;
  std::vector<PlottedPrediction> predictions;
};

/// Reads run records and predictions. `methods` are the ones to draw of each prediction; none: the best
/// usable one of each. Throws InputError, also for differing units, a method that no prediction has, and a
/// prediction that does not say its period.
PlotInputs read_plot_inputs(const std::vector<std::string>& files, const std::vector<std::string>& methods);

/// "um", "s" and "um/s"; "lattice units" in lattice units.
std::string length_unit(const Units& units);
std::string time_unit(const Units& units);
std::string velocity_unit(const Units& units);

/// A line on each run: what it is of and how it was resolved.
std::vector<std::string> run_notes(const PlotInputs& inputs);

/// "lbm", or "lbm FILE" where several runs must be told apart.
std::string run_label(const PlotInputs& inputs, const PlottedRun& run);

}  // namespace beadswim
