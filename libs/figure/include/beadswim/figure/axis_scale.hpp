#pragma once

#include <string>
#include <vector>

namespace beadswim {

enum class TickKind { any, integers };

enum class ScaleKind { linear, logarithmic };

/// Number format of the tick labels of an axis.
enum class TickLabels {
  decimals,  ///< for example 0.2, 0.4
  digits,    ///< for example 1, 2, 5, 10
  powers,    ///< for example 10⁻⁵, 10⁻⁴
};

/// Range and ticks of an axis. Tick labels may omit a power of ten, which the axis label then contains.
struct AxisScale {
  double low = 0, high = 1;  ///< ends of the axis
  std::vector<double> ticks;
  std::vector<double> minor_ticks{};  ///< ticks without labels
  int exponent = 0;                   ///< a label is tick / 10^exponent; 0 if no power of ten is omitted
  int decimals = 0;                   ///< number of decimals of the labels
  ScaleKind kind = ScaleKind::linear;
  TickLabels labels = TickLabels::decimals;

  /// Returns the position of a value along the axis: 0 at `low` and 1 at `high`. On a logarithmic axis,
  /// returns a non-finite number if the value is not positive.
  double fraction(double value) const;
  std::string tick_label(double tick) const;
};

/// Returns a linear scale for data in [low, high], with a margin on both sides. The bounds are finite and
/// low <= high. There are about five ticks; their distance is 1, 2 or 5 times a power of ten.
AxisScale linear_scale(double low, double high, TickKind kind);

/// Returns a logarithmic scale for data in [low, high], 0 < low <= high, with a margin on both sides. The
/// ticks are at these values:
///   two decades or more  powers of ten
///   one to two decades   1, 2, 3 and 5 times a power of ten
///   less than a decade   as in linear_scale()
AxisScale logarithmic_scale(double low, double high);

/// Returns a power of ten as text, for example "10⁻⁵" for -5.
std::string power_of_ten(int exponent);

}  // namespace beadswim
