#pragma once

#include <string>
#include <vector>

#include "beadswim/figure/axis_scale.hpp"

// Figures as SVG. The same figure gives the same bytes: fixed palette, fixed number formats, no date.

namespace beadswim {

enum class Mark { points, line, line_and_points };

enum class Emphasis {
  plain,
  faint,  ///< thin and pale; has no say in where the y axis ends, and is cut off there
};

/// Points (x[i], y[i]). Those that are not finite, or not positive on a logarithmic axis, are left out, and
/// a line breaks there.
struct Series {
  std::string label;  ///< its line in the legend; none if empty
  std::vector<double> x{}, y{};
  Mark mark = Mark::points;
  int colour = 0;  ///< position in the palette of Okabe and Ito; wraps round
  int shape = 0;   ///< of the points: filled circle, square, triangle, diamond, then open ones; wraps round
  int dash = 0;    ///< of the line: solid, dashed, dotted, dash-dotted, long, dash-dot-dotted; wraps round
  Emphasis emphasis = Emphasis::plain;
};

/// "quantity (unit)" or, without unit, "quantity".
struct AxisLabel {
  std::string quantity;
  std::string unit{};
};

struct Panel {
  AxisLabel x_label, y_label;
  std::vector<Series> series{};
  TickKind x_ticks = TickKind::any;
  ScaleKind x_scale = ScaleKind::linear, y_scale = ScaleKind::linear;
};

/// Panels one above the other, each with its legend at the right; notes (parameters, sources) below.
struct Figure {
  std::string title;
  std::vector<Panel> panels;
  std::vector<std::string> notes{};
};

/// A whole SVG document. Throws InputError if a panel holds no point that can be drawn.
std::string figure_to_svg(const Figure& figure);

}  // namespace beadswim
