#include "svg.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "beadswim/core/xml_text.hpp"

namespace beadswim::svg {
namespace {

constexpr double marker_radius = 3.6;
constexpr double head_slenderness = 7 / 2.6;  // of arrow heads: length over half width
constexpr double mean_glyph_width = 0.57;     // relative to the font size, for text in DejaVu Sans

/// Formats a number with two decimals. Writes "0.00" instead of "-0.00".
std::string number(double value) {
  const double rounded = std::round(value * 100) / 100;
  return fmt::format("{:.2f}", rounded == 0 ? 0.0 : rounded);
}

/// Returns the points as the value of the attribute "points".
std::string coordinates(const std::vector<Point>& points) {
  std::string list;
  for (const Point& point : points) {
    list += fmt::format("{}{},{}", list.empty() ? "" : " ", number(point.x()), number(point.y()));
  }
  return list;
}

std::string opacity_attribute(double opacity) {
  return opacity == 1 ? "" : fmt::format(R"( opacity="{}")", number(opacity));
}

std::string attributes(const Stroke& stroke) {
  std::string result = fmt::format(R"(stroke="{}" stroke-width="{}")", stroke.colour, number(stroke.width));
  if (!stroke.dashes.empty()) result += fmt::format(R"( stroke-dasharray="{}")", stroke.dashes);
  return result + opacity_attribute(stroke.opacity);
}

/// Returns a text element. `content` is markup, in which special characters are already escaped.
std::string text_element(Point at, const std::string& content, const TextStyle& style) {
  constexpr std::array anchors{"start", "middle", "end"};
  std::string extra;
  if (style.rotation != 0) {
    extra = fmt::format(" transform=\"rotate({} {} {})\"", number(style.rotation), number(at.x()),
                        number(at.y()));
  }
  if (style.halo != 0) {
    extra +=
        fmt::format(" paint-order=\"stroke\" stroke=\"#ffffff\" stroke-width=\"{}\"", number(style.halo));
  }
  return fmt::format(
      "<text x=\"{}\" y=\"{}\" font-size=\"{}\" font-weight=\"{}\" text-anchor=\"{}\"{}>{}</text>\n",
      number(at.x()), number(at.y()), number(style.size), style.weight,
      anchors[static_cast<std::size_t>(style.anchor)], extra, content);
}

/// Returns the path of a closed polygon. `corners` are relative to the centre, in units of `radius`.
std::string outline(Point centre, double radius, const std::vector<Point>& corners) {
  std::string path;
  for (const Point& corner : corners) {
    const Point at = centre + radius * corner;
    path += fmt::format("{}{} {}", path.empty() ? "M" : " L", number(at.x()), number(at.y()));
  }
  return path + " Z";
}

const std::array<std::vector<Point>, 3>& marker_outlines() {
  static const std::array<std::vector<Point>, 3> outlines{
      std::vector<Point>{{-0.89, -0.89}, {0.89, -0.89}, {0.89, 0.89}, {-0.89, 0.89}},  // square
      std::vector<Point>{{0, -1.2}, {1.1, 0.8}, {-1.1, 0.8}},                          // triangle
      std::vector<Point>{{0, -1.3}, {1.3, 0}, {0, 1.3}, {-1.3, 0}},                    // diamond
  };
  return outlines;
}

}  // namespace

std::string mixed(const std::string& first, const std::string& second, double share) {
  std::string result = "#";
  for (std::size_t channel = 1; channel < 7; channel += 2) {
    const int from = std::stoi(first.substr(channel, 2), nullptr, 16);
    const int to = std::stoi(second.substr(channel, 2), nullptr, 16);
    result += fmt::format("{:02x}", std::lround(from + share * (to - from)));
  }
  return result;
}

std::string line(Point from, Point to, const Stroke& stroke) {
  return fmt::format("<line x1=\"{}\" y1=\"{}\" x2=\"{}\" y2=\"{}\" {}/>\n", number(from.x()),
                     number(from.y()), number(to.x()), number(to.y()), attributes(stroke));
}

std::string polyline(const std::vector<Point>& points, const Stroke& stroke) {
  return fmt::format("<polyline points=\"{}\" fill=\"none\" stroke-linejoin=\"round\" {}/>\n",
                     coordinates(points), attributes(stroke));
}

std::vector<std::vector<Point>> visible_parts(const std::vector<Point>& points, double top, double bottom) {
  const auto contains = [&](const Point& point) { return point.y() >= top && point.y() <= bottom; };
  const auto exit_point = [&](const Point& inside, const Point& outside) {
    const double y = outside.y() < top ? top : bottom;
    const double part = (y - inside.y()) / (outside.y() - inside.y());
    return Point(inside.x() + part * (outside.x() - inside.x()), y);
  };
  std::vector<std::vector<Point>> parts;
  const Point* last = nullptr;  // nullptr: the line is interrupted before the point
  for (const Point& point : points) {
    const bool inside = point.allFinite() && contains(point);
    const bool was_inside = last != nullptr && contains(*last);
    if (inside && !was_inside) parts.emplace_back();
    if (inside && last != nullptr && !was_inside) parts.back().push_back(exit_point(point, *last));
    if (inside) parts.back().push_back(point);
    if (was_inside && !inside && point.allFinite()) parts.back().push_back(exit_point(*last, point));
    last = point.allFinite() ? &point : nullptr;
  }
  return parts;
}

std::string area(const std::vector<Point>& points, const std::string& fill, double opacity) {
  return fmt::format("<polygon points=\"{}\" fill=\"{}\" fill-opacity=\"{}\"/>\n", coordinates(points), fill,
                     number(opacity));
}

std::string filled_rectangle(Point first, Point opposite, const std::string& fill) {
  return area({first, {opposite.x(), first.y()}, opposite, {first.x(), opposite.y()}}, fill, 1);
}

std::string rectangle(Point top_left, double width, double height, const Stroke& stroke) {
  return fmt::format("<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" fill=\"none\" {}/>\n",
                     number(top_left.x()), number(top_left.y()), number(width), number(height),
                     attributes(stroke));
}

std::string text(Point at, const std::string& content, const TextStyle& style) {
  return text_element(at, xml_text(content), style);
}

std::string formula(Point at, const std::string& content, const TextStyle& style) {
  const double drop = 0.28 * style.size;
  std::size_t mark = content.find('_');
  std::string markup = xml_text(content.substr(0, mark));
  while (mark < content.size()) {
    const std::size_t next = content.find('_', mark + 1);
    const std::string rest = content.substr(mark + 1, next - mark - 1);
    // Some programs omit a space at the start of a tspan. A horizontal shift replaces it.
    const bool apart = rest.substr(1, 1) == " ";
    markup += fmt::format(
        "<tspan dy=\"{}\" font-size=\"{}\" stroke=\"none\">{}</tspan><tspan dx=\"{}\" dy=\"{}\">{}</tspan>",
        number(drop), number(0.72 * style.size), xml_text(rest.substr(0, 1)),
        number(apart ? 0.32 * style.size : 0), number(-drop), xml_text(rest.substr(apart ? 2 : 1)));
    mark = next;
  }
  return text_element(at, markup, style);
}

std::string disc(Point centre, double radius, const std::string& fill, const Stroke& stroke) {
  return fmt::format("<circle cx=\"{}\" cy=\"{}\" r=\"{}\" fill=\"{}\" {}/>\n", number(centre.x()),
                     number(centre.y()), number(radius), fill, attributes(stroke));
}

std::string arrow_head(Point from, Point to, const std::string& colour, double length) {
  const Point along = (to - from).normalized(), foot = to - length * along;
  const Point across = length / head_slenderness * Point(-along.y(), along.x());
  return fmt::format("<path d=\"{}\" fill=\"{}\"/>\n",
                     outline(Point::Zero(), 1, {to, foot + across, foot - across}), colour);
}

std::string arrow(Point from, Point to, const Stroke& stroke) {
  return line(from, to, stroke) + arrow_head(from, to, stroke.colour);
}

std::string double_arrow(Point from, Point to, const Stroke& stroke) {
  return arrow(from, to, stroke) + arrow_head(to, from, stroke.colour);
}

std::string marker(Point centre, int shape, const std::string& colour, double opacity) {
  const int form = shape % marker_shapes;
  const std::string fill = form < marker_shapes / 2 ? colour : "#ffffff";
  const std::string paint =
      fmt::format(R"(fill="{}" stroke="{}" stroke-width="1.30")", fill, colour) + opacity_attribute(opacity);
  const auto corners = static_cast<std::size_t>(form % (marker_shapes / 2));
  if (corners == 0) {
    return fmt::format("<circle cx=\"{}\" cy=\"{}\" r=\"{}\" {}/>\n", number(centre.x()), number(centre.y()),
                       number(marker_radius), paint);
  }
  return fmt::format("<path d=\"{}\" {}/>\n", outline(centre, marker_radius, marker_outlines()[corners - 1]),
                     paint);
}

double text_width(const std::string& content, double size) {
  const auto code_points = std::count_if(content.begin(), content.end(),
                                         [](unsigned char byte) { return (byte & 0xC0U) != 0x80U; });
  return mean_glyph_width * size * static_cast<double>(code_points);
}

std::string document(double width, double height, const std::string& title, const std::string& elements) {
  return fmt::format(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" height=\"{1}\" viewBox=\"0 0 {0} {1}\" "
      "font-family=\"DejaVu Sans, sans-serif\" fill=\"#000000\">\n<title>{2}</title>\n"
      "<rect width=\"100%\" height=\"100%\" fill=\"#ffffff\"/>\n{3}</svg>\n",
      number(width), number(height), xml_text(title), elements);
}

}  // namespace beadswim::svg
