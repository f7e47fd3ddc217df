#include "beadswim/compare/figure.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "beadswim/core/error.hpp"
#include "svg.hpp"

namespace beadswim {
namespace {

// Okabe and Ito's palette for all kinds of colour vision, without yellow, which is faint on white.
constexpr std::array palette{"#0072B2", "#D55E00", "#009E73", "#CC79A7", "#E69F00", "#56B4E9", "#000000"};
constexpr std::array dashes{"", "6 4", "1.5 3", "8 3 2 3"};

// The page, in px.
constexpr double margin = 16;
constexpr double plot_left = 84;
constexpr double plot_width = 440;
constexpr double plot_height = 220;
constexpr double first_plot_top = 52;
constexpr double panel_pitch = plot_height + 66;  // leaves room for tick labels and the x label
constexpr double legend_left = plot_left + plot_width + 18;
constexpr double legend_key_width = 30;
constexpr double line_pitch = 18;
constexpr double tick_length = 5;
constexpr double title_size = 14, label_size = 12.5, tick_size = 11, note_size = 10;

const svg::Stroke frame_stroke{"#000000", 1, ""};
const svg::Stroke grid_stroke{"#e4e4e4", 0.8, ""};

/// Where a panel is on the page and how data map to it.
struct PlotArea {
  double top = 0;
  AxisScale x, y;

  svg::Point at(double data_x, double data_y) const {
    return {plot_left + plot_width * x.fraction(data_x), top + plot_height * (1 - y.fraction(data_y))};
  }
  double bottom() const { return top + plot_height; }
};

struct Range {
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();

  void include(double value) {
    low = std::min(low, value);
    high = std::max(high, value);
  }
};

bool drawable(const Series& series, std::size_t i) {
  return std::isfinite(series.x[i]) && std::isfinite(series.y[i]);
}

PlotArea plot_area(const Panel& panel, double top) {
  Range x, y;
  for (const Series& series : panel.series) {
    for (std::size_t i = 0; i < series.x.size(); ++i) {
      if (!drawable(series, i)) continue;
      x.include(series.x[i]);
      y.include(series.y[i]);
    }
  }
  if (x.high < x.low)
    throw InputError("figure", fmt::format("no finite point to draw for \"{}\"", panel.y_label.quantity));
  return {top, nice_scale(x.low, x.high, panel.x_ticks), nice_scale(y.low, y.high, TickKind::any)};
}

/// "⁻⁵" for -5.
std::string superscript(int exponent) {
  constexpr std::array digits{"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
  std::string text = exponent < 0 ? "⁻" : "";
  for (const char digit : std::to_string(std::abs(exponent))) {
    text += digits[static_cast<std::size_t>(digit - '0')];
  }
  return text;
}

/// "velocity (10⁻⁵ um/s)": the unit with the power of ten that the tick labels leave out.
std::string label_text(const AxisLabel& label, int exponent) {
  const std::string power = exponent == 0 ? "" : "10" + superscript(exponent);
  const std::string gap = power.empty() || label.unit.empty() ? "" : " ";
  const std::string unit = power + gap + label.unit;
  return unit.empty() ? label.quantity : fmt::format("{} ({})", label.quantity, unit);
}

std::string draw_x_axis(const PlotArea& area, const AxisLabel& label) {
  std::string elements;
  for (const double tick : area.x.ticks) {
    const double x = area.at(tick, area.y.low).x;
    elements += svg::line({x, area.top}, {x, area.bottom()}, grid_stroke);
    elements += svg::line({x, area.bottom()}, {x, area.bottom() + tick_length}, frame_stroke);
    elements += svg::text({x, area.bottom() + 18}, area.x.tick_label(tick), {tick_size, svg::Anchor::middle});
  }
  return elements + svg::text({plot_left + plot_width / 2, area.bottom() + 38},
                              label_text(label, area.x.exponent), {label_size, svg::Anchor::middle});
}

std::string draw_y_axis(const PlotArea& area, const AxisLabel& label) {
  std::string elements;
  for (const double tick : area.y.ticks) {
    const double y = area.at(area.x.low, tick).y;
    elements += svg::line({plot_left, y}, {plot_left + plot_width, y}, grid_stroke);
    elements += svg::line({plot_left - tick_length, y}, {plot_left, y}, frame_stroke);
    elements += svg::text({plot_left - tick_length - 4, y + 4}, area.y.tick_label(tick),
                          {tick_size, svg::Anchor::end});
  }
  return elements + svg::text({margin + 8, area.top + plot_height / 2}, label_text(label, area.y.exponent),
                              {label_size, svg::Anchor::middle, -90});
}

svg::Stroke line_stroke(const Series& series) {
  return {palette[static_cast<std::size_t>(series.colour) % palette.size()], 1.8,
          dashes[static_cast<std::size_t>(series.dash) % dashes.size()]};
}

std::string draw_line(const Series& series, const std::vector<svg::Point>& points) {
  return series.mark == Mark::points ? "" : svg::polyline(points, line_stroke(series));
}

std::string draw_points(const Series& series, const std::vector<svg::Point>& points) {
  std::string elements;
  if (series.mark == Mark::line) return elements;
  for (const svg::Point& point : points) {
    elements += svg::marker(point, series.shape, line_stroke(series).colour);
  }
  return elements;
}

std::string draw_series(const PlotArea& area, const Series& series) {
  std::vector<svg::Point> points;
  for (std::size_t i = 0; i < series.x.size(); ++i) {
    if (drawable(series, i)) points.push_back(area.at(series.x[i], series.y[i]));
  }
  return draw_line(series, points) + draw_points(series, points);
}

std::string draw_legend(const PlotArea& area, const std::vector<Series>& all_series) {
  std::string elements;
  double y = area.top + 10;
  for (const Series& series : all_series) {
    const double right = legend_left + legend_key_width;
    elements += draw_line(series, {{legend_left, y}, {right, y}});
    elements += draw_points(series, {{legend_left + legend_key_width / 2, y}});
    elements += svg::text({right + 8, y + 4}, series.label, {tick_size});
    y += line_pitch;
  }
  return elements;
}

std::string draw_panel(const Panel& panel, double top) {
  const PlotArea area = plot_area(panel, top);
  std::string elements = draw_x_axis(area, panel.x_label) + draw_y_axis(area, panel.y_label);
  elements += svg::rectangle({plot_left, top}, plot_width, plot_height, frame_stroke);
  // Lines first, so that no point hides behind one.
  for (const Series& series : panel.series) {
    if (series.mark != Mark::points) elements += draw_series(area, series);
  }
  for (const Series& series : panel.series) {
    if (series.mark == Mark::points) elements += draw_series(area, series);
  }
  return elements + draw_legend(area, panel.series);
}

double page_width(const Figure& figure) {
  double right = std::max(plot_left + plot_width, plot_left + svg::text_width(figure.title, title_size));
  for (const std::string& note : figure.notes)
    right = std::max(right, plot_left + svg::text_width(note, note_size));
  for (const Panel& panel : figure.panels) {
    for (const Series& series : panel.series) {
      right = std::max(right, legend_left + legend_key_width + 8 + svg::text_width(series.label, tick_size));
    }
  }
  return std::ceil(right + margin);
}

}  // namespace

std::string figure_to_svg(const Figure& figure) {
  std::string elements =
      svg::text({plot_left, 30}, figure.title, {title_size, svg::Anchor::start, 0, "bold"});
  double top = first_plot_top;
  for (const Panel& panel : figure.panels) {
    elements += draw_panel(panel, top);
    top += panel_pitch;
  }
  for (const std::string& note : figure.notes) {
    elements += svg::text({plot_left, top}, note, {note_size});
    top += line_pitch - 3;
  }
  return svg::document(page_width(figure), top + margin - line_pitch / 2, figure.title, elements);
}

}  // namespace beadswim
