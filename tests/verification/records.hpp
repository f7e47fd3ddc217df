#pragma once

#include <string>
#include <vector>

#include "beadswim/io/json.hpp"

// Records of measurements: statistics, selection, and printing of numbers.

namespace beadswim::verification {

struct MeanAndDeviation {
  double mean, deviation;  ///< standard deviation of the population
};
MeanAndDeviation mean_and_deviation(const std::vector<double>& values);

/// Returns the records that have these values, in their order. Numbers match to 1e-9.
std::vector<Json> where(const std::vector<Json>& records, const Json& values);

/// Returns the schemes that occur in the records, in the order of BeadScheme.
std::vector<std::string> schemes_in(const std::vector<Json>& records);

/// Returns a fraction in percent, with its sign and with as many digits as are significant.
std::string percent(double fraction);

/// Returns "error" ± "spread" of one record in percent, without the unit.
std::string error_and_spread(const Json& record);

}  // namespace beadswim::verification
