#pragma once

#include <map>
#include <span>
#include <string>
#include <vector>

#include "beadswim/compare/result_quantity.hpp"

// Errors and costs of runs. Runs that differ only in resolution have the same setting. The runs are grouped
// by setting and sorted by resolution.

namespace beadswim {

/// A run with its cost and the results of its swimmers.
struct CostedRun {
  std::string source;     ///< file of the run
  std::string setting;    ///< describes all settings of the run except the resolution
  double resolution = 0;  ///< cells per bead radius; 0 for models without a lattice
  double cost = 0;        ///< for example core-seconds per period [s]
  std::vector<Results> swimmers;
};

/// Errors of all runs with the same setting and the same resolution.
struct ErrorsAtResolution {
  double resolution = 0;                      ///< cells per bead radius
  std::string source;                         ///< file of the first run
  double cost = 0;                            ///< median cost of the runs [s]
  std::map<ResultQuantity, double> errors;    ///< root mean square of the relative errors of all runs
};

/// Errors of all runs with the same setting (all settings except the resolution are equal).
struct ErrorsOfSetting {
  std::string setting;
  std::vector<ErrorsAtResolution> resolutions;  ///< in order of increasing resolution
};

/// Returns the relative errors of the runs for each quantity that reference and run contain, which must have
/// equal numbers of values, and equal numbers of swimmers if `reference` has several. The error of a run
/// with several swimmers is the root mean square of their differences from the reference, divided by the root
/// mean square of the reference, so that a swimmer with a small velocity does not dominate. `reference`
/// contains the correct values, either in one entry for all swimmers or in one entry per swimmer. The result
/// is in the order in which settings first occur in `runs`.
std::vector<ErrorsOfSetting> errors_by_setting(std::span<const CostedRun> runs,
                                               std::span<const Results> reference);

}  // namespace beadswim
