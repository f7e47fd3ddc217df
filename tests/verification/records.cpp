#include "records.hpp"

#include <fmt/format.h>

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

double fitted_order(const std::vector<double>& resolution, const std::vector<double>& error) {
  const double count = static_cast<double>(error.size());
  double x = 0, y = 0, xx = 0, xy = 0;
  for (std::size_t k = 0; k < error.size(); ++k) {
    const double lx = std::log(resolution[k]), ly = std::log(error[k]);
    x += lx, y += ly, xx += lx * lx, xy += lx * ly;
  }
  return -(count * xy - x * y) / (count * xx - x * x);
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
  return fmt::format("{:+.{}f} %", 100 * fraction, digits_for(100 * fraction));
}

std::string plain_percent(double fraction) {
  return fmt::format("{:.{}f} %", 100 * fraction, digits_for(100 * fraction));
}

std::string table_head(const std::string& first, const std::vector<std::string>& columns) {
  std::string head = "| " + first + " |", line = "|---|";
  for (const std::string& column : columns) {
    head += " " + column + " |";
    line += "---|";
  }
  return head + "\n" + line + "\n";
}

std::string error_and_spread(const Json& record) {
  if (record["places"] == 1) return percent(record["error"]);
  return fmt::format("{} ± {}", percent(record["error"]), plain_percent(record["spread"]));
}

namespace {

/// One row a value of `key`, one column a scheme.
template <class T>
std::string table_by(const std::string& key, const std::string& title, const std::vector<Json>& records) {
  const std::vector<std::string> schemes = schemes_in(records);
  std::string text = table_head(title, schemes);
  for (const T value : values_of<T>(records, key)) {
    text += fmt::format("| {} |", value);
    for (const std::string& scheme : schemes) {
      const auto found = where(records, {{key, value}, {"scheme", scheme}});
      text += found.empty() ? " |" : " " + error_and_spread(found[0]) + " |";
    }
    text += "\n";
  }
  return text;
}

std::string order_of(const std::vector<double>& resolution, const std::vector<double>& error) {
  return error.size() < 3 ? "-" : fmt::format("{:.1f}", fitted_order(resolution, error));
}

std::string order_row(const std::vector<Json>& records) {
  constexpr int coarsest = 6;  // cells a diameter
  std::string row = "| order of mean, of spread |";
  for (const std::string& scheme : schemes_in(records)) {
    std::vector<double> cells, error, spread_cells, spread;
    for (const Json& r : where(records, {{"scheme", scheme}})) {
      if (r["cells_per_diameter"] < coarsest) continue;
      cells.push_back(r["diameter"]);
      error.push_back(std::abs(r["error"].get<double>()));
      if (r["places"] == 1) continue;
      spread_cells.push_back(r["diameter"]);
      spread.push_back(r["spread"]);
    }
    row += " " + order_of(cells, error) + ", " + order_of(spread_cells, spread) + " |";
  }
  return row + "\n";
}

}  // namespace

std::string resolution_table(const std::vector<Json>& records) {
  return table_by<int>("cells_per_diameter", "cells a diameter", records) + order_row(records);
}

std::string relaxation_table(const std::vector<Json>& records) {
  return table_by<double>("tau", "τ", records);
}

}  // namespace beadswim::verification
