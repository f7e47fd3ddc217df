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
};

/// All in the same units; each group in the order of the command line.
struct PlotInputs {
  Units units;
  std::vector<PlottedRun> runs;
  std::vector<PlottedPrediction> predictions;
  std::vector<std::string> methods;           ///< of the predictions, in the order of drawing
  std::vector<PlottedPrediction> references;  ///< by the method that others are drawn relative to
};

struct MethodChoice {
  std::vector<std::string> methods{};  ///< of each prediction; none: its best usable one; "all": all
  std::string relative_to{};           ///< the method of the references; empty: none
};

/// Reads run records and predictions: files of one document, or of one document a line. Throws InputError
/// naming file and line, also for differing units and for a method that no prediction has.
PlotInputs read_plot_inputs(const std::vector<std::string>& files, const MethodChoice& choice);

}  // namespace beadswim
