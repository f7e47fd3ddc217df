#include "beadswim/compare/run_uncertainty.hpp"

#include <algorithm>
#include <cmath>

namespace beadswim {

std::optional<double> total_uncertainty(const QuantityUncertainty& uncertainty) {
  const auto& [resolution, wander, transient, total, box] = uncertainty;
  if (!resolution || !wander || !transient) return std::nullopt;
  return std::hypot(*resolution, *wander, *transient);
}

std::optional<double> remaining_change(std::span<const double> values) {
  if (values.size() < 2 || values.back() == 0) return std::nullopt;
  const auto last = values.last(std::min<std::size_t>(values.size(), 3));
  const double change = std::abs(last[last.size() - 1] - last[last.size() - 2]);
  constexpr double least = 0.5, most = 0.9;
  const double before = last.size() == 3 ? std::abs(last[1] - last[0]) : 0;
  const double ratio = before > 0 ? std::clamp(change / before, least, most) : least;
  return ratio / (1 - ratio) * change / std::abs(last.back());
}

}  // namespace beadswim
