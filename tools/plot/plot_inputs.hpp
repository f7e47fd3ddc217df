#pragma once

#include <string>
#include <vector>

#include "beadswim/compare/cycle_choice.hpp"
#include "beadswim/documents/results.hpp"
#include "beadswim/documents/swimming_document.hpp"

// Run records and predictions that a figure shows.

namespace beadswim {

/// Prediction by one method.
struct PlottedPrediction {
  std::string source;
  PredictionDocument document;  ///< with this prediction alone

  const Prediction& prediction() const { return document.predictions.front(); }
  Results results() const;
};

/// Run records and predictions that a figure shows, with their common units. Each list is in the order of the
/// command line.
struct PlotInputs {
  Units units;
  std::vector<RunFile> runs{};
  std::vector<PlottedPrediction> predictions{};
  std::vector<std::string> methods{};           ///< methods of the predictions, in the order of drawing
  std::vector<PlottedPrediction> references{};  ///< predictions by the method InputChoice::relative_to

  /// Returns the studies of all inputs that belong to one.
  std::vector<Json> studies() const;
};

/// What is drawn of the inputs.
struct InputChoice {
  std::vector<std::string> methods{};  ///< methods to draw; empty: the best usable method; "all": all methods
  std::string relative_to{};           ///< method of the references; empty: no references
  CycleChoice cycle{};                 ///< cycles of runs
};

/// Reads run records and predictions from files, which contain one document, or one document per line. Leaves
/// out, and counts on standard error, what has no result: failures, runs without the chosen cycles, and
/// predictions that no chosen method made. Throws InputError if a document is invalid, if nothing has a
/// result, if units differ, or if no prediction was made by a method that `wanted` names.
PlotInputs read_plot_inputs(const std::vector<std::string>& files, const InputChoice& wanted);

/// Throws InputError if the files have different units.
void require_same_units(const Units& units, const std::string& source, const Units& first,
                        const std::string& first_source);

/// Returns the only file. Throws InputError, which states the rule, if there is another number of files.
std::string only_file(const std::vector<std::string>& files, const std::string& rule);

}  // namespace beadswim
