#pragma once

#include <string>
#include <vector>

#include "beadswim/figure/axis_scale.hpp"
#include "beadswim/figure/drawing.hpp"

// Figures of panels with axes: lines and points with legends, or maps.

namespace beadswim {

enum class Mark { points, line, line_and_points };

enum class Emphasis {
  plain,
  faint,  ///< thin and pale; does not affect the range of the y axis, and is clipped to it
};

/// Points (x[i], y[i]). Non-finite points are omitted, and so are points that are not positive on a
/// logarithmic axis. A line is interrupted at an omitted point.
struct Series {
  std::string label;  ///< text in the legend; if empty, the series is not in the legend
  std::vector<double> x{}, y{};
  std::vector<double> errors{};  ///< half lengths of bars at points and half widths of bands along lines, in
                                 ///< units of y; empty: none
  Mark mark = Mark::points;
  int colour = 0;  ///< index in the palette of Okabe and Ito, modulo its size
  int shape = 0;   ///< 0 to 3: filled circle, square, triangle, diamond; 4 to 7: open; modulo 8
  int dash = 0;    ///< 0 to 5: solid, dashed, dotted, dash-dotted, long, dash-dot-dotted; modulo 6
  Emphasis emphasis = Emphasis::plain;
  std::string data_label{};  ///< label of the numbers (Drawing::csv), if it is not `label`
};

/// A value at (x, y), shown as the colour of a rectangle around this point.
struct MapCell {
  double x = 0, y = 0, value = 0;
  double x_low = 0, x_high = 0, y_low = 0, y_high = 0;  ///< edges of the rectangle
};

struct Panel {
  AxisLabel x_label, y_label;
  std::vector<Series> series{};
  std::vector<MapCell> cells{};  ///< a map; its colours, from dark to light, are explained by a bar
  AxisLabel value_label{};       ///< label of the values of the map
  TickKind x_ticks = TickKind::any;
  ScaleKind x_scale = ScaleKind::linear, y_scale = ScaleKind::linear;
  std::string title{};  ///< text above the panel; empty: none
};

/// Panels in one column, each with its legend to the right, and notes below the panels.
struct Figure {
  std::string title;
  std::vector<Panel> panels;
  std::vector<Note> notes{};
  bool has_common_legend = false;  ///< true: one legend for all panels; equal labels have equal styles
};

/// Draws the figure. Its numbers are a line per point: names and units of both axes, label of the series, x,
/// y, and the error if the series has any. Faint points follow the plain ones; those of a curve are the
/// series "LABEL (not usable)". For maps: names and units of x, y and the value, and the three numbers.
/// Throws InputError if a panel has no point that can be drawn.
Drawing draw(const Figure& figure);

}  // namespace beadswim
