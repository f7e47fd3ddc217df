#pragma once

#include <map>
#include <span>
#include <string>
#include <vector>

#include "beadswim/compare/swimming.hpp"

// Errors and costs of runs, grouped by setting and sorted by resolution.

namespace beadswim {

/// A run with its cost and the compared quantities of its swimmers.
struct CostedRun {
  std::string source;     ///< file of the run
  std::string setting;    ///< everything that distinguishes runs, except the resolution
  double resolution = 0;  ///< cells per bead radius; 0 for models without a lattice
  double cost = 0;        ///< [s]
  std::vector<ComparedValues> swimmers;
};

/// Errors of all runs that share a setting and a resolution.
struct ErrorsAtResolution {
  double resolution = 0;  ///< cells per bead radius
  std::string source;     ///< file of the first run
  double cost = 0;        ///< median cost of the runs [s]
  std::map<ComparedQuantity, double>
      errors;  ///< root mean square of the relative errors of runs and swimmers
};

/// Errors of all runs that share a setting.
struct ErrorsOfSetting {
  std::string setting;
  std::vector<ErrorsAtResolution> resolutions;  ///< in order of increasing resolution
};

/// Returns the errors in those quantities that the reference contains. Settings are in the order of their
/// first run. `reference` has one entry for all swimmers or one entry per swimmer.
std::vector<ErrorsOfSetting> errors_by_setting(std::span<const CostedRun> runs,
                                               std::span<const ComparedValues> reference);

}  // namespace beadswim
