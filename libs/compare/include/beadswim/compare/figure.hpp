#pragma once

#include <string>
#include <vector>

#include "beadswim/compare/axis_scale.hpp"

// Figures as SVG. The same figure gives the same bytes: fixed palette, fixed number formats, no date.

namespace beadswim {

enum class Mark { points, line, line_and_points };

/// Points (x[i], y[i]); those that are not finite are left out.
struct Series {
  std::string label;  ///< its line in the legend
  std::vector<double> x{}, y{};
  Mark mark = Mark::points;
  int colour = 0;  ///< position in the palette of Okabe and Ito; wraps round
  int shape = 0;   ///< of the points: filled circle, square, triangle, diamond, then open ones; wraps round
  int dash = 0;    ///< of the line: solid, dashed, dotted, dash-dotted; wraps round
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
};

/// Panels one above the other, each with its legend at the right; notes (parameters, sources) below.
struct Figure {
  std::string title;
  std::vector<Panel> panels;
  std::vector<std::string> notes{};
};

/// A whole SVG document. Throws InputError if a panel holds no finite point.
std::string figure_to_svg(const Figure& figure);

}  // namespace beadswim
