#pragma once

#include <string>
#include <vector>

#include "beadswim/io/json.hpp"

// Records of measurements: statistics, choice, and how numbers are printed.

namespace beadswim::verification {

struct MeanAndDeviation {
  double mean, deviation;  ///< standard deviation, of the values as all there are
};
MeanAndDeviation mean_and_deviation(const std::vector<double>& values);

/// -d ln error/d ln resolution, least squares.
double fitted_order(const std::vector<double>& resolution, const std::vector<double>& error);

/// Those with these values, in their order. Numbers match to 1e-9.
std::vector<Json> where(const std::vector<Json>& records, const Json& values);

/// The values of a key, ascending, each once.
template <class T>
std::vector<T> values_of(const std::vector<Json>& records, const std::string& key) {
  std::vector<T> values;
  for (const Json& r : records) {
    if (r.contains(key)) values.push_back(r[key].get<T>());
  }
  std::ranges::sort(values);
  values.erase(std::unique(values.begin(), values.end()), values.end());
  return values;
}

/// Schemes in the records, in the order of the list of schemes.
std::vector<std::string> schemes_in(const std::vector<Json>& records);

/// "+1.2 %", with as many digits as matter.
std::string percent(double fraction);
/// The same without a sign.
std::string plain_percent(double fraction);

/// "| first | a | b |" and the line below.
std::string table_head(const std::string& first, const std::vector<std::string>& columns);

/// "error" ± "spread" of one record in percent.
std::string error_and_spread(const Json& record);

/// Errors of the schemes by cells a diameter, and the orders fitted from 6 cells on; by relaxation time.
std::string resolution_table(const std::vector<Json>& records);
std::string relaxation_table(const std::vector<Json>& records);

}  // namespace beadswim::verification
