#include "quantised.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace beadswim {
namespace {

constexpr int max_steps = std::numeric_limits<std::int16_t>::max();

}  // namespace

float smallest_step(double largest) {
  return std::nextafter(static_cast<float>(largest / max_steps), largest > 0 ? INFINITY : 0.F);
}

std::int16_t round_to_steps(double number, float step) {
  const double steps = step > 0 ? std::round(number / step) : 0;
  if (std::isnan(number) || std::isnan(steps)) return not_a_number;
  return static_cast<std::int16_t>(std::clamp<double>(steps, -max_steps, max_steps));
}

QuantisedTable quantised(std::span<const double> rows, std::size_t columns) {
  std::vector<double> largest(columns, 0);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (!std::isnan(rows[i])) largest[i % columns] = std::max(largest[i % columns], std::abs(rows[i]));
  }
  QuantisedTable table;
  for (const double number : largest) table.steps.push_back(smallest_step(number));
  for (std::size_t i = 0; i < rows.size(); ++i) {
    table.values.push_back(round_to_steps(rows[i], table.steps[i % columns]));
  }
  return table;
}

}  // namespace beadswim
