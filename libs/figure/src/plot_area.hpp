#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "beadswim/figure/axis_scale.hpp"
#include "beadswim/figure/figure.hpp"
#include "svg.hpp"

// Axes around a plot, and the colour bar at its right.

namespace beadswim {

inline constexpr double title_size = 14, label_size = 12.5, tick_size = 11;  // font sizes [px]
inline constexpr double page_margin = 16, plot_left = 84, plot_top = 52;     // of the page [px]
inline constexpr double below_plot = 66;  // for tick labels and the x label [px]
inline constexpr double panel_width = 440, panel_height = 220;               // of the plot of a panel [px]
inline constexpr double legend_gap = 18;  // between a plot and its legend or colour bar [px]

inline const svg::Stroke frame_stroke{.colour = "#000000", .width = 1};

/// Place of a plot on the page [px], and its mapping of data to points on the page.
struct PlotArea {
  double top = 0, width = panel_width, height = panel_height;
  AxisScale x, y;

  svg::Point at(double data_x, double data_y) const {
    return {plot_left + width * x.fraction(data_x), top + height * (1 - y.fraction(data_y))};
  }
  double bottom() const { return top + height; }
  double legend_left() const { return plot_left + width + legend_gap; }
  /// Returns true if the point is in the plot between top and bottom; false for a non-finite point.
  bool contains(const svg::Point& point) const {
    return std::isfinite(point.x()) && point.y() >= top && point.y() <= bottom();
  }
};

/// Returns the text of an axis label with unit, for example "velocity (10⁻⁵ um/s)". The text contains the
/// power of ten by which the tick labels must be multiplied.
std::string label_text(const AxisLabel& label, int exponent);

// Draw an axis: grid lines, ticks and label.
std::string draw_x_axis(const PlotArea& area, const AxisLabel& label);
std::string draw_y_axis(const PlotArea& area, const AxisLabel& label);

/// Colours of the values of a map.
struct ColourScale {
  AxisScale values;
  std::string (*colour)(double share) = nullptr;  ///< 0: colour of the least value, 1: of the largest

  /// Returns the place of a value between the ends of the scale, from 0 to 1.
  double share_of(double value) const;
};

/// Returns the colour between the nearest two of some colours at equal distances. `share`: 0 for the first, 1
/// for the last.
template <std::size_t count>
std::string colour_between(const std::array<const char*, count>& stops, double share) {
  const double place = std::clamp(share, 0.0, 1.0) * (count - 1);
  const std::size_t before = std::min(static_cast<std::size_t>(place), count - 2);
  return svg::mixed(stops[before], stops[before + 1], place - static_cast<double>(before));
}

/// Returns a colour from dark blue (0) over green to yellow (1), whose lightness grows evenly.
std::string dark_to_light(double share);

/// Draws a colour bar with ticks, and the name of the value above it. `height`: of both [px].
std::string draw_colour_bar(svg::Point top_left, double height, const ColourScale& scale,
                            const AxisLabel& label);

/// Returns the room for a colour bar and its label [px].
double colour_bar_width(const AxisLabel& label);

}  // namespace beadswim
