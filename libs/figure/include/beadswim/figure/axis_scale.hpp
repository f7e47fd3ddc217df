#pragma once

#include <string>
#include <vector>

namespace beadswim {

enum class TickKind { any, integers };

enum class ScaleKind { linear, logarithmic };

/// How the ticks of an axis are written.
enum class TickLabels {
  decimals,  ///< 0.2, 0.4
  digits,    ///< 1, 2, 5, 10
  powers,    ///< 10⁻⁵, 10⁻⁴
};

/// Where an axis ends and where its ticks are. Tick labels leave out the power of ten that the axis label
/// then names.
struct AxisScale {
  double low = 0, high = 1;  ///< ends of the axis
  std::vector<double> ticks;
  std::vector<double> minor_ticks{};  ///< without label
  int exponent = 0;                   ///< labels are tick / 10^exponent; 0 where plain numbers read well
  int decimals = 0;                   ///< of the labels
  ScaleKind kind = ScaleKind::linear;
  TickLabels labels = TickLabels::decimals;

  /// 0 at low, 1 at high; not finite on a logarithmic axis for a value that is not positive.
  double fraction(double value) const;
  std::string tick_label(double tick) const;
};

/// A scale for data in [low, high] (finite, low <= high) with about five ticks, 1, 2 or 5 times a power of
/// ten apart, and a margin around the data. One value alone gets room on both sides.
AxisScale nice_scale(double low, double high, TickKind kind);

/// A logarithmic scale for data in [low, high], 0 < low <= high: ticks at powers of ten over two decades or
/// more; at 1, 2, 3 and 5 times a power of ten over less; where not even one decade is covered, as
/// nice_scale.
AxisScale logarithmic_scale(double low, double high);

/// "10⁻⁵" for -5.
std::string power_of_ten(int exponent);

}  // namespace beadswim
