#include "records.hpp"

#include <fmt/core.h>

#include <cmath>
#include <numeric>

#include "beadswim/coupling/bead_scheme.hpp"

namespace beadswim::verification {
namespace {

bool is_same(const Json& a, const Json& b) {
  if (!a.is_number() || !b.is_number()) return a == b;
  return std::abs(a.get<double>() - b.get<double>()) < 1e-9;
}

int digits_for(double percentage) {
  const double size = std::abs(percentage);
  return size >= 10 ? 1 : (size >= 0.1 ? 2 : 3);
}

}  // namespace

MeanAndDeviation mean_and_deviation(const std::vector<double>& values) {
  const double count = static_cast<double>(values.size());
  const double mean = std::accumulate(values.begin(), values.end(), 0.0) / count;
  double squares = 0;
  for (const double v : values) squares += (v - mean) * (v - mean);
  return {mean, std::sqrt(squares / count)};
}

std::vector<Json> where(const std::vector<Json>& records, const Json& values) {
  std::vector<Json> found;
  for (const Json& r : records) {
    bool all = true;
    for (const auto& [key, value] : values.items()) all = all && r.contains(key) && is_same(r[key], value);
    if (all) found.push_back(r);
  }
  return found;
}

std::vector<std::string> schemes_in(const std::vector<Json>& records) {
  std::vector<std::string> schemes;
  for (const std::string& name : all_names<BeadScheme>()) {
    if (!where(records, {{"scheme", name}}).empty()) schemes.push_back(name);
  }
  return schemes;
}

std::string percent(double fraction) {
  return fmt::format("{:+.{}f}", 100 * fraction, digits_for(100 * fraction));
}

std::string error_and_spread(const Json& record) {
  if (record["places"] == 1) return percent(record["error"]);
  const double spread = 100 * record["spread"].get<double>();
  return fmt::format("{} ± {:.{}f}", percent(record["error"]), spread, digits_for(spread));
}

}  // namespace beadswim::verification
