#pragma once

#include <string>
#include <vector>

// Elements of an SVG document as text. Lengths are in px. Numbers have two decimals, so that the bytes depend
// only on the arguments.

namespace beadswim::svg {

struct Point {
  double x = 0, y = 0;
};

struct Stroke {
  std::string colour;
  double width = 1;
  std::string dashes;  ///< value of stroke-dasharray; empty: solid line
  double opacity = 1;
};

enum class Anchor { start, middle, end };

struct TextStyle {
  double size = 12;
  Anchor anchor = Anchor::start;
  double rotation = 0;  ///< about the anchor point [degree]
  std::string weight = "normal";
  double halo = 0;  ///< width of a white outline of the letters, for text over other elements [px]
};

inline constexpr int marker_shapes = 8;

std::string line(Point from, Point to, const Stroke& stroke);
std::string polyline(const std::vector<Point>& points, const Stroke& stroke);
/// Returns a filled area without outline.
std::string area(const std::vector<Point>& points, const std::string& fill, double opacity);
std::string disc(Point centre, double radius, const std::string& fill, const Stroke& stroke);
std::string rectangle(Point top_left, double width, double height, const Stroke& stroke);
std::string text(Point at, const std::string& content, const TextStyle& style);

/// Returns text in which "_" makes the next character a subscript: "D_x = 56". The subscript is an ASCII
/// character.
std::string formula(Point at, const std::string& content, const TextStyle& style);

/// Returns a line with an arrow head at its end.
std::string arrow(Point from, Point to, const Stroke& stroke);
/// Returns a line with arrow heads at both ends.
std::string double_arrow(Point from, Point to, const Stroke& stroke);

/// Returns a marker. Shapes 0 to 3 are a filled circle, square, triangle and diamond; shapes 4 to 7 are open.
std::string marker(Point centre, int shape, const std::string& colour, double opacity);

/// Returns an upper estimate of the width of a line of text in DejaVu Sans [px], from the number of code
/// points.
double text_width(const std::string& content, double size);

/// Returns a document that contains the elements on a white background.
std::string document(double width, double height, const std::string& title, const std::string& elements);

}  // namespace beadswim::svg
