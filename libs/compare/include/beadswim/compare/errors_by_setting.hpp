#pragma once

#include <map>
#include <span>
#include <string>
#include <vector>

#include "beadswim/compare/swimming.hpp"

// Errors of runs against their costs: runs of one setting, in order of their resolution.

namespace beadswim {

/// A run, its cost, and how its swimmers swim.
struct CostedRun {
  std::string source;
  std::string setting;    ///< all that sets runs apart, but for the resolution
  double resolution = 0;  ///< cells per bead radius; 0 without a lattice
  double cost = 0;        ///< [s]
  std::vector<Swimming> swimmers;
};

/// Errors of runs of one setting at one resolution.
struct ErrorsAtResolution {
  double resolution = 0;
  std::string source;                         ///< of the first run
  double cost = 0;                            ///< median of the runs' [s]
  std::map<ComparedQuantity, double> errors;  ///< root mean square over runs and swimmers, relative
};

struct ErrorsOfSetting {
  std::string setting;
  std::vector<ErrorsAtResolution> resolutions;  ///< in increasing order
};

/// Errors in the quantities that the reference knows, by setting in order of its first run. `reference` has
/// one entry for all swimmers, or one for each.
std::vector<ErrorsOfSetting> errors_by_setting(std::span<const CostedRun> runs,
                                               std::span<const Swimming> reference);

}  // namespace beadswim
