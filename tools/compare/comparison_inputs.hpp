#pragma once

#include <optional>
#include <string>
#include <vector>

#include "beadswim/compare/comparison.hpp"
#include "beadswim/compare/cycle_choice.hpp"
#include "beadswim/documents/swimming_document.hpp"
#include "beadswim/documents/verdict_document.hpp"

// Comparison of run records with predictions and other records.

namespace beadswim {

/// The command line of beadswim-compare.
struct ComparisonRequest {
  std::vector<std::string> files;               ///< run records; the last file is the reference
  std::vector<std::string> further_references;  ///< compared in addition to the reference
  std::optional<int> swimmer;                   ///< id; nullopt: see compare()
  std::string table;                            ///< file of result_table(); empty: the runs are compared
  std::optional<std::string> method;            ///< method of the verdict; nullopt: best_reference()
  std::vector<ResultQuantity> quantities;
  double tolerance = 0.05;  ///< largest accepted |relative error|
  CycleChoice cycle;
  std::vector<std::string> allowed_differences;    ///< properties in which run and reference may differ
  bool shows_all = false;                          ///< the table on standard error has all rows
};

struct ComparisonInputs {
  std::vector<RunFile> runs;
  std::vector<SourceDocument> references;  ///< the file REFERENCE, then the files of --reference
};

/// Throws InputError if the document is the record of a failed run, whose results are not valid, or of a
/// large swarm without a cycle.
void require_success(const SwimmingDocument& document, const std::string& source);

/// Compares each run with every reference. Unless the request names a swimmer, the swimmer of the prediction
/// is compared if the reference is a prediction, and all its swimmers if it is a run. Throws InputError if
/// units or scenes differ, if there is no such swimmer, if a run has failed, or if no usable method can
/// determine the verdict.
VerdictDocument compare(const ComparisonInputs& inputs, const ComparisonRequest& request);

}  // namespace beadswim
