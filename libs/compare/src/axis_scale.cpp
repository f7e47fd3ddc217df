#include "beadswim/compare/axis_scale.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

namespace beadswim {
namespace {

constexpr double wanted_intervals = 5;
constexpr double wanted_integer_intervals = 7;  // so that each of up to six cycles has its tick
constexpr double margin = 0.06;                 // of the data's range, on each side
constexpr double lone_value_margin = 0.1;       // of the value

/// 1, 2 or 5 times a power of ten, near `step`.
double round_step(double step) {
  const double decade = std::pow(10.0, std::floor(std::log10(step)));
  const double leading = step / decade;  // in [1, 10)
  const double multiple = leading < 1.5 ? 1 : leading < 3.5 ? 2 : leading < 7.5 ? 5 : 10;
  return multiple * decade;
}

/// Multiples of step in [low, high], by integer count so that rounding does not pile up.
std::vector<double> multiples_within(double low, double high, double step) {
  std::vector<double> ticks;
  const auto last = static_cast<long long>(std::floor(high / step + 1e-9));
  for (auto i = static_cast<long long>(std::ceil(low / step - 1e-9)); i <= last; ++i) {
    ticks.push_back(static_cast<double>(i) * step);
  }
  return ticks;
}

int decimal_exponent(double value) {
  return static_cast<int>(std::floor(std::log10(value) + 1e-9));
}

}  // namespace

std::string AxisScale::tick_label(double tick) const {
  const double shown = tick / std::pow(10.0, exponent);
  return fmt::format("{:.{}f}", shown == 0 ? 0.0 : shown, decimals);  // no "-0"
}

AxisScale nice_scale(double low, double high, TickKind kind) {
  AxisScale scale;
  const double spread = high > low ? margin * (high - low)
                        : low != 0 ? lone_value_margin * std::abs(low)
                                   : 1.0;
  scale.low = low - spread;
  scale.high = high + spread;
  const double length = scale.high - scale.low;
  const double step = kind == TickKind::any ? round_step(length / wanted_intervals)
                                            : std::max(1.0, round_step(length / wanted_integer_intervals));
  scale.ticks = multiples_within(scale.low, scale.high, step);
  const double largest = std::max(std::abs(scale.low), std::abs(scale.high));
  const bool plain = largest >= 0.01 && largest < 1e5;
  scale.exponent = plain ? 0 : decimal_exponent(largest);
  scale.decimals = std::max(0, scale.exponent - decimal_exponent(step));
  return scale;
}

}  // namespace beadswim
