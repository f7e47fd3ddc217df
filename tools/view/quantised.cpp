#include "quantised.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace beadswim {
namespace {

constexpr int most_steps = std::numeric_limits<std::int16_t>::max();

}  // namespace

float step_for(double largest) {
  return std::nextafter(static_cast<float>(largest / most_steps), largest > 0 ? INFINITY : 0.F);
}

std::int16_t in_steps(double number, float step) {
  const double steps = step > 0 ? std::round(number / step) : 0;
  if (std::isnan(number) || std::isnan(steps)) return not_a_number;
  return static_cast<std::int16_t>(std::clamp<double>(steps, -most_steps, most_steps));
}

QuantisedTable quantised(std::span<const double> rows, std::size_t columns) {
  std::vector<double> largest(columns, 0);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (!std::isnan(rows[i])) largest[i % columns] = std::max(largest[i % columns], std::abs(rows[i]));
  }
  QuantisedTable table;
  for (const double number : largest) table.steps.push_back(step_for(number));
  for (std::size_t i = 0; i < rows.size(); ++i) {
    table.values.push_back(in_steps(rows[i], table.steps[i % columns]));
  }
  return table;
}

}  // namespace beadswim
