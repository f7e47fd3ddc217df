#pragma once

#include <string>
#include <vector>

namespace beadswim {

enum class TickKind { any, integers };

enum class ScaleKind { linear, logarithmic };

struct Tick {
  double value = 0;
  std::string label{};
};

/// Range and ticks of an axis. Tick labels may omit a power of ten, which the axis label then contains.
struct AxisScale {
  double low = 0, high = 1;  ///< ends of the axis
  std::vector<Tick> ticks{};
  std::vector<double> minor_ticks{};  ///< ticks without labels
  int exponent = 0;                   ///< a label is value / 10^exponent; 0 if no power of ten is omitted
  ScaleKind kind = ScaleKind::linear;

  /// Returns the position of a value along the axis: 0 at `low` and 1 at `high`. On a logarithmic axis,
  /// returns a non-finite number if the value is not positive.
  double fraction(double value) const;
};

/// Returns a linear scale for data in [low, high], with a margin on both sides. The bounds are finite and
/// low <= high. There are about five ticks; their distance is 1, 2 or 5 times a power of ten.
AxisScale linear_scale(double low, double high, TickKind kind);

/// Returns a logarithmic scale for data in [low, high], 0 < low <= high, with a margin on both sides. The
/// ticks are at these values:
///   two decades or more  powers of ten, labelled 10⁻⁵, 10⁻⁴
///   one to two decades   1, 2, 3 and 5 times a power of ten
///   less than a decade   as in linear_scale()
AxisScale logarithmic_scale(double low, double high);

/// Returns a scale that ends at `low` and at `high`, with the ticks of linear_scale() or logarithmic_scale()
/// between them.
AxisScale exact_scale(double low, double high, ScaleKind kind);

/// Returns a power of ten as text, for example "10⁻⁵" for -5.
std::string power_of_ten(int exponent);

}  // namespace beadswim
