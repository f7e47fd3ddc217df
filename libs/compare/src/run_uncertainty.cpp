#include "beadswim/compare/run_uncertainty.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

namespace beadswim {

std::string in_percent(double share) {
  if (share > 10) return "more than 1000 %";
  return share < 1 ? fmt::format("{:.2g} %", 100 * share) : fmt::format("{:.0f} %", 100 * share);
}

std::optional<double> total_uncertainty(const QuantityUncertainty& uncertainty) {
  const auto& [resolution, wander, transient, total, box] = uncertainty;
  if (!resolution || !wander || !transient) return std::nullopt;
  return std::hypot(*resolution, *wander, *transient);
}

std::optional<double> remaining_change(std::span<const double> values) {
  const std::size_t count = values.size();
  if (count < 2 || values.back() == 0) return std::nullopt;
  const double change = values[count - 1] - values[count - 2];
  constexpr double usual = 0.5, most = 0.9;
  double ratio = usual;
  if (count > 2) {
    const double before = values[count - 2] - values[count - 3];
    if (before != 0 && change / before < 1) ratio = std::clamp(change / before, usual, most);
  }
  return ratio / (1 - ratio) * std::abs(change / values.back());
}

}  // namespace beadswim
