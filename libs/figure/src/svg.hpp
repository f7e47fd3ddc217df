#pragma once

#include <string>
#include <vector>

// Elements of an SVG document, as text. Lengths in px, numbers with two decimals: bytes depend on the
// arguments alone.

namespace beadswim::svg {

struct Point {
  double x = 0, y = 0;
};

struct Stroke {
  std::string colour;
  double width = 1;
  std::string dashes;  ///< as in stroke-dasharray; empty: solid
  double opacity = 1;
};

enum class Anchor { start, middle, end };

struct TextStyle {
  double size = 12;
  Anchor anchor = Anchor::start;
  double rotation = 0;  ///< degrees, about the text's own point
  std::string weight = "normal";
  double halo = 0;  ///< width of the white around the letters, where other things lie behind them
};

inline constexpr int marker_shapes = 8;

std::string line(Point from, Point to, const Stroke& stroke);
std::string polyline(const std::vector<Point>& points, const Stroke& stroke);
std::string disc(Point centre, double radius, const std::string& fill, const Stroke& stroke);
std::string rectangle(Point top_left, double width, double height, const Stroke& stroke);
std::string text(Point at, const std::string& content, const TextStyle& style);

/// Text in which "_" puts the next character, an ASCII one, below the line: "D_x = 56".
std::string formula(Point at, const std::string& content, const TextStyle& style);

/// A line with a head at its end; with one at either end, as of a distance.
std::string arrow(Point from, Point to, const Stroke& stroke);
std::string double_arrow(Point from, Point to, const Stroke& stroke);

/// Shape 0 to 3: filled circle, square, triangle, diamond; 4 to 7: the same, open.
std::string marker(Point centre, int shape, const std::string& colour, double opacity);

/// An estimate, on the safe side, of the width of a line of DejaVu Sans; counts code points.
double text_width(const std::string& content, double size);

/// The document around its elements, on white.
std::string document(double width, double height, const std::string& title, const std::string& elements);

}  // namespace beadswim::svg
