#pragma once

#include <optional>
#include <string>
#include <vector>

#include "beadswim/core/names.hpp"
#include "beadswim/figure/figure.hpp"

// Makes the series (points or lines with one style) of a panel of a figure from numbers: measured points,
// predicted curves and constant levels.

namespace beadswim {

struct CurvePoint {
  double x = 0, y = 0;
  bool usable = true;  ///< false: the point of a line is drawn faintly
  double error = 0;    ///< half length of the bar at a mark, or half width of the band around a line
};

/// Points with a common label, in order of x if a line connects them.
struct Curve {
  std::string label;
  std::vector<CurvePoint> points{};
};

/// Appends to the panel each element of `marks` as filled markers, then each curve as a line. A curve with
/// few points also has open markers. Parts of curves that are not usable (CurvePoint::usable) are faint. All
/// series have the colour `colour`, an index in the palette. Without `colour`, each series has its own
/// colour.
void append_marks_and_curves(const std::vector<Curve>& marks, const std::vector<Curve>& curves,
                             std::optional<int> colour, Panel& panel);

/// Appends to the panel one horizontal line for the first point of each level, from x = `from` to x = `to`,
/// each with its own dash pattern.
void append_levels(const std::vector<Curve>& levels, double from, double to, int colour, Panel& panel);

enum class Axes {
  automatic,  ///< logarithmic if the y values of plain series are positive and span > 2 decades, else linear
  linear,
  log_y,
  log_log,
};

template <>
inline constexpr auto name_table<Axes> = std::to_array<NamedValue<Axes>>({{Axes::automatic, "auto"},
                                                                          {Axes::linear, "linear"},
                                                                          {Axes::log_y, "log-y"},
                                                                          {Axes::log_log, "log-log"}});

/// Sets the scales (linear or logarithmic) of the axes of a panel whose series are complete. For
/// Axes::automatic, the kind of axes is `logarithmic_axes` if the y values span more than two decades,
/// otherwise Axes::linear.
void set_axes(Axes axes, Axes logarithmic_axes, Panel& panel);

/// Returns true if the y axis is logarithmic and some y values are not positive. These values are not drawn.
bool has_omitted_values(const Panel& panel);

}  // namespace beadswim
