#pragma once

#include <array>
#include <string>
#include <vector>

#include "beadswim/core/vec3.hpp"
#include "beadswim/figure/drawing.hpp"

// Elements of an SVG document as text. Lengths are in px. Numbers have two decimals, so that the bytes depend
// only on the arguments.

namespace beadswim::svg {

/// Palette of Okabe and Ito for all kinds of colour vision. Yellow is omitted because it is faint on white.
inline constexpr std::array palette{"#0072B2", "#D55E00", "#009E73", "#CC79A7",
                                    "#E69F00", "#56B4E9", "#000000"};

/// Returns the index of a colour in the palette, modulo the size of the palette.
constexpr std::size_t palette_place(int colour) {
  return static_cast<std::size_t>(colour) % palette.size();
}

/// Returns a mixture of two colours "#rrggbb". `share`: weight of the second colour.
std::string mixed(const std::string& first, const std::string& second, double share);

/// A place on the page, with y downwards.
using Point = Eigen::Vector2d;

struct Stroke {
  std::string colour;
  double width = 1;
  std::string dashes{};  ///< value of stroke-dasharray; empty: solid line
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
/// Clips the line through `points` to the range between `top` and `bottom`. Returns the visible parts. The
/// line is interrupted at non-finite points. It is also interrupted between two consecutive points outside
/// the range: if they are on opposite sides, they indicate a pole, which the line must not cross.
std::vector<std::vector<Point>> visible_parts(const std::vector<Point>& points, double top, double bottom);
/// Returns a filled area without outline.
std::string area(const std::vector<Point>& points, const std::string& fill, double opacity);
std::string disc(Point centre, double radius, const std::string& fill, const Stroke& stroke);
/// Returns a filled rectangle without outline, between two opposite corners.
std::string filled_rectangle(Point first, Point opposite, const std::string& fill);
std::string rectangle(Point top_left, double width, double height, const Stroke& stroke);
std::string text(Point at, const std::string& content, const TextStyle& style);

/// Returns text in which "_" makes the next character a subscript: "D_x = 56". The subscript is an ASCII
/// character.
std::string formula(Point at, const std::string& content, const TextStyle& style);

/// Returns an arrow head with its tip at `to`, of an arrow that starts at `from`.
std::string arrow_head(Point from, Point to, const std::string& colour, double length = 7);
/// Returns a line with an arrow head at its end.
std::string arrow(Point from, Point to, const Stroke& stroke);
/// Returns a line with arrow heads at both ends.
std::string double_arrow(Point from, Point to, const Stroke& stroke);

/// Returns a marker. Shapes 0 to 3 are a filled circle, square, triangle and diamond; shapes 4 to 7 are open.
std::string marker(Point centre, int shape, const std::string& colour, double opacity);

/// Returns an upper estimate of the width of a line of text in DejaVu Sans [px], from the number of code
/// points.
double text_width(const std::string& content, double size);

/// Notes as SVG elements.
struct NoteBlock {
  std::string elements;  ///< a group of the class "notes"; empty if there is no note
  double bottom = 0;     ///< baseline of the last line, or one line above `top_left` if there is no note
};

/// Draws the notes of a drawing, shortened by shorten_notes(). Each note starts a new line, and is wrapped to
/// `width`. `top_left` is the start of the baseline of the first line.
NoteBlock draw_notes(const std::vector<Note>& notes, Point top_left, double width);

/// Returns a document that contains the elements on a white background.
std::string document(double width, double height, const std::string& title, const std::string& elements);

}  // namespace beadswim::svg
