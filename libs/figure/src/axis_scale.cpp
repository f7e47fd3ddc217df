#include "beadswim/figure/axis_scale.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>

namespace beadswim {
namespace {

constexpr double target_intervals = 5;
constexpr double target_integer_intervals = 7;  // an axis of up to six cycles then has one tick per cycle
constexpr double margin = 0.06;                 // on each side, divided by the range of the data
constexpr double single_value_margin = 0.1;     // relative to the value, on each side

/// Returns 1, 2, 5 or 10 times a power of ten, close to `step`.
double round_step(double step) {
  const double decade = std::pow(10.0, std::floor(std::log10(step)));
  const double leading = step / decade;  // in [1, 10)
  const double multiple = leading < 1.5 ? 1 : leading < 3.5 ? 2 : leading < 7.5 ? 5 : 10;
  return multiple * decade;
}

/// Returns the multiples of `step` in [low, high]. An integer counter prevents the accumulation of roundoff.
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

/// Adds ticks at equal distances to an axis whose ends are set. The distance between neighbouring ticks is 1,
/// 2 or 5 times a power of ten.
void add_round_ticks(AxisScale& scale, TickKind kind) {
  const double length = scale.high - scale.low;
  const double step = kind == TickKind::any ? round_step(length / target_intervals)
                                            : std::max(1.0, round_step(length / target_integer_intervals));
  const double largest = std::max(std::abs(scale.low), std::abs(scale.high));
  const bool plain = largest >= 0.01 && largest < 1e5;
  scale.exponent = plain ? 0 : decimal_exponent(largest);
  const int decimals = std::max(0, scale.exponent - decimal_exponent(step));
  for (const double tick : multiples_within(scale.low, scale.high, step)) {
    const double shown = tick / std::pow(10.0, scale.exponent);
    scale.ticks.push_back({tick, fmt::format("{:.{}f}", shown == 0 ? 0.0 : shown, decimals)});  // avoids "-0"
  }
}

/// Returns the given multiples of all powers of ten that are within the range of the axis.
std::vector<double> decade_ticks(const AxisScale& scale, std::initializer_list<int> multiples) {
  std::vector<double> ticks;
  for (int decade = decimal_exponent(scale.low); decade <= decimal_exponent(scale.high); ++decade) {
    for (const int multiple : multiples) {
      const double tick = multiple * std::pow(10.0, decade);
      if (tick >= scale.low && tick <= scale.high) ticks.push_back(tick);
    }
  }
  return ticks;
}

}  // namespace

double AxisScale::fraction(double value) const {
  if (kind == ScaleKind::linear) return (value - low) / (high - low);
  return std::log(value / low) / std::log(high / low);
}

AxisScale linear_scale(double low, double high, TickKind kind) {
  AxisScale scale;
  const double spread = high > low ? margin * (high - low)
                        : low != 0 ? single_value_margin * std::abs(low)
                                   : 1.0;
  scale.low = low - spread;
  scale.high = high + spread;
  add_round_ticks(scale, kind);
  return scale;
}

AxisScale logarithmic_scale(double low, double high) {
  const double spread = high > low ? std::pow(high / low, margin) : 1 + single_value_margin;
  AxisScale scale;
  scale.low = low / spread;
  scale.high = high * spread;
  scale.kind = ScaleKind::logarithmic;
  const double decades = std::log10(scale.high / scale.low);
  if (decades < 1) {
    add_round_ticks(scale, TickKind::any);
    return scale;
  }
  scale.minor_ticks = decade_ticks(scale, {1, 2, 3, 4, 5, 6, 7, 8, 9});
  if (decades >= 2) {
    for (const double tick : decade_ticks(scale, {1}))
      scale.ticks.push_back({tick, power_of_ten(static_cast<int>(std::lround(std::log10(tick))))});
    return scale;
  }
  const bool plain = scale.low >= 0.01 && scale.high < 1e5;
  scale.exponent = plain ? 0 : decimal_exponent(scale.low);
  for (const double tick : decade_ticks(scale, {1, 2, 3, 5}))
    scale.ticks.push_back({tick, fmt::format("{:g}", tick / std::pow(10.0, scale.exponent))});
  return scale;
}

AxisScale exact_scale(double low, double high, ScaleKind kind) {
  AxisScale scale =
      kind == ScaleKind::linear ? linear_scale(low, high, TickKind::any) : logarithmic_scale(low, high);
  scale.low = low;
  scale.high = high;
  const auto is_outside = [&](double value) { return value < low || value > high; };
  std::erase_if(scale.ticks, [&](const Tick& tick) { return is_outside(tick.value); });
  std::erase_if(scale.minor_ticks, is_outside);
  return scale;
}

std::string power_of_ten(int exponent) {
  constexpr std::array digits{"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
  std::string text = exponent < 0 ? "10⁻" : "10";
  for (const char digit : std::to_string(std::abs(exponent))) {
    text += digits[static_cast<std::size_t>(digit - '0')];
  }
  return text;
}

}  // namespace beadswim
