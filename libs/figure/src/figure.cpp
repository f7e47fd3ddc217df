#include "beadswim/figure/figure.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "beadswim/core/error.hpp"
#include "palette.hpp"
#include "svg.hpp"
#include "visible_stretches.hpp"

namespace beadswim {
namespace {

constexpr std::array dashes{"", "6 4", "1.5 3", "8 3 2 3", "13 4", "8 3 2 3 2 3"};
constexpr double line_width = 1.8, faint_line_width = 1.1;
constexpr double faint_opacity = 0.65;

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
constexpr double tick_length = 5, minor_tick_length = 3;
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
  /// False also for a point that is not finite.
  bool holds(const svg::Point& point) const {
    return std::isfinite(point.x) && point.y >= top && point.y <= bottom();
  }
};

struct Range {
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();

  void include(double value) {
    low = std::min(low, value);
    high = std::max(high, value);
  }
};

/// Whether an axis of that scale has a place for the value.
bool has_place(double value, ScaleKind scale) {
  return std::isfinite(value) && (scale == ScaleKind::linear || value > 0);
}

struct PanelRange {
  Range x, y;

  void include(const Series& series, const Panel& panel) {
    for (std::size_t i = 0; i < series.x.size(); ++i) {
      if (!has_place(series.x[i], panel.x_scale) || !has_place(series.y[i], panel.y_scale)) continue;
      x.include(series.x[i]);
      y.include(series.y[i]);
    }
  }
  bool is_empty() const { return x.high < x.low; }
};

/// Of the plain series, or of all if they have nothing to draw; along x always of all.
PanelRange panel_range(const Panel& panel) {
  PanelRange plain, all;
  for (const Series& series : panel.series) {
    all.include(series, panel);
    if (series.emphasis == Emphasis::plain) plain.include(series, panel);
  }
  if (all.is_empty()) {
    const bool logarithmic = panel.y_scale == ScaleKind::logarithmic;
    throw InputError("figure", fmt::format("no {} point to draw for \"{}\"",
                                           logarithmic ? "positive" : "finite", panel.y_label.quantity));
  }
  return {all.x, plain.is_empty() ? all.y : plain.y};
}

AxisScale axis_scale(const Range& range, ScaleKind scale, TickKind ticks) {
  return scale == ScaleKind::linear ? nice_scale(range.low, range.high, ticks)
                                    : logarithmic_scale(range.low, range.high);
}

PlotArea plot_area(const Panel& panel, double top) {
  const PanelRange range = panel_range(panel);
  return {top, axis_scale(range.x, panel.x_scale, panel.x_ticks),
          axis_scale(range.y, panel.y_scale, TickKind::any)};
}

/// "velocity (10⁻⁵ um/s)": the unit with the power of ten that the tick labels leave out.
std::string label_text(const AxisLabel& label, int exponent) {
  const std::string power = exponent == 0 ? "" : power_of_ten(exponent);
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
  for (const double tick : area.x.minor_ticks) {
    const double x = area.at(tick, area.y.low).x;
    elements += svg::line({x, area.bottom()}, {x, area.bottom() + minor_tick_length}, frame_stroke);
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
  for (const double tick : area.y.minor_ticks) {
    const double y = area.at(area.x.low, tick).y;
    elements += svg::line({plot_left - minor_tick_length, y}, {plot_left, y}, frame_stroke);
  }
  return elements + svg::text({margin + 8, area.top + plot_height / 2}, label_text(label, area.y.exponent),
                              {label_size, svg::Anchor::middle, -90});
}

svg::Stroke line_stroke(const Series& series) {
  const bool plain = series.emphasis == Emphasis::plain;
  return {palette[palette_place(series.colour)], plain ? line_width : faint_line_width,
          dashes[static_cast<std::size_t>(series.dash) % dashes.size()], plain ? 1.0 : faint_opacity};
}

std::string draw_line(const Series& series, const Stretch& stretch) {
  return series.mark == Mark::points ? "" : svg::polyline(stretch, line_stroke(series));
}

std::string draw_points(const Series& series, const Stretch& stretch) {
  std::string elements;
  if (series.mark == Mark::line) return elements;
  const svg::Stroke stroke = line_stroke(series);
  for (const svg::Point& point : stretch) {
    elements += svg::marker(point, series.shape, stroke.colour, stroke.opacity);
  }
  return elements;
}

std::string draw_series(const PlotArea& area, const Series& series) {
  std::vector<svg::Point> points;
  Stretch inside;
  for (std::size_t i = 0; i < series.x.size(); ++i) {
    points.push_back(area.at(series.x[i], series.y[i]));
    if (area.holds(points.back())) inside.push_back(points.back());
  }
  std::string elements;
  for (const Stretch& stretch : visible_stretches(points, area.top, area.bottom())) {
    elements += draw_line(series, stretch);
  }
  return elements + draw_points(series, inside);
}

/// From a panel's top to the next one's: its plot with labels, or its legend if that is longer.
double pitch(const Panel& panel) {
  const auto entries = std::ranges::count_if(panel.series, [](const Series& s) { return !s.label.empty(); });
  return std::max(panel_pitch, line_pitch * static_cast<double>(entries + 1));
}

std::string draw_legend(const PlotArea& area, const std::vector<Series>& all_series) {
  std::string elements;
  double y = area.top + 10;
  for (const Series& series : all_series) {
    if (series.label.empty()) continue;
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
    top += pitch(panel);
  }
  for (const std::string& note : figure.notes) {
    elements += svg::text({plot_left, top}, note, {note_size});
    top += line_pitch - 3;
  }
  return svg::document(page_width(figure), top + margin - line_pitch / 2, figure.title, elements);
}

}  // namespace beadswim
