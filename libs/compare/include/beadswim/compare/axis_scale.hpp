#pragma once

#include <string>
#include <vector>

namespace beadswim {

enum class TickKind { any, integers };

/// Where an axis ends and where its ticks are. Tick labels leave out the power of ten that the axis label
/// then names.
struct AxisScale {
  double low = 0, high = 1;  ///< ends of the axis
  std::vector<double> ticks;
  int exponent = 0;  ///< labels are tick / 10^exponent; 0 where plain numbers read well
  int decimals = 0;  ///< of the labels

  double fraction(double value) const { return (value - low) / (high - low); }  ///< 0 at low, 1 at high
  std::string tick_label(double tick) const;
};

/// A scale for data in [low, high] (finite, low <= high) with about five ticks, 1, 2 or 5 times a power of
/// ten apart, and a margin around the data. One value alone gets room on both sides.
AxisScale nice_scale(double low, double high, TickKind kind);

}  // namespace beadswim
