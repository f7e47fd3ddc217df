#pragma once

#include <optional>
#include <string>
#include <vector>

#include "beadswim/compare/comparison.hpp"
#include "beadswim/compare/cycle_choice.hpp"
#include "beadswim/documents/swimming_document.hpp"
#include "beadswim/documents/verdict_document.hpp"

// From files to a verdict.

namespace beadswim {

/// What the command line asks for.
struct ComparisonRequest {
  std::vector<std::string> files;               ///< runs, then the reference
  std::vector<std::string> further_references;  ///< shown beside the reference
  std::optional<std::string> method;            ///< decides; none: the best of the reference's
  std::vector<ComparedQuantity> quantities;
  double tolerance = 0;
  CycleChoice cycle;
};

/// Reads all files and compares each run, swimmer by swimmer, with every reference: the one swimmer that a
/// predicting REFERENCE speaks of, or all swimmers of a REFERENCE that is a run. Throws InputError for files
/// that cannot be read or that describe different scenes, and if no usable method can decide.
VerdictDocument compare_files(const ComparisonRequest& request);

}  // namespace beadswim
