#include "beadswim/figure/figure.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <tuple>

#include "beadswim/core/error.hpp"
#include "beadswim/core/vec3.hpp"
#include "svg.hpp"

namespace beadswim {
namespace {

constexpr std::array dashes{"", "6 4", "1.5 3", "8 3 2 3", "13 4", "8 3 2 3 2 3"};
constexpr double line_width = 1.8, faint_line_width = 1.1;
constexpr double faint_opacity = 0.65;

// Dimensions of the page [px].
constexpr double margin = 16;
constexpr double plot_left = 84;
constexpr double plot_width = 440;
constexpr double plot_height = 220;
constexpr double first_plot_top = 52;
constexpr double panel_pitch = plot_height + 66;  // includes space for tick labels and the x label
constexpr double legend_left = plot_left + plot_width + 18;
constexpr double legend_key_width = 30;
constexpr double line_pitch = 18;
constexpr double tick_length = 5, minor_tick_length = 3;
constexpr double title_size = 14, label_size = 12.5, tick_size = 11;

const svg::Stroke frame_stroke{.colour = "#000000", .width = 1, .dashes = ""};
const svg::Stroke grid_stroke{.colour = "#e4e4e4", .width = 0.8, .dashes = ""};

/// Position of a panel on the page, and its mapping of data to points on the page.
struct PlotArea {
  double top = 0;
  AxisScale x, y;

  svg::Point at(double data_x, double data_y) const {
    return {plot_left + plot_width * x.fraction(data_x), top + plot_height * (1 - y.fraction(data_y))};
  }
  double bottom() const { return top + plot_height; }
  /// Returns true if the point is in the plot between top and bottom; false for a non-finite point.
  bool contains(const svg::Point& point) const {
    return std::isfinite(point.x) && point.y >= top && point.y <= bottom();
  }
};

/// Returns true if an axis with this scale can show the value.
bool can_show(double value, ScaleKind scale) {
  return std::isfinite(value) && (scale == ScaleKind::linear || value > 0);
}

double error_at(const Series& series, std::size_t i) {
  return i < series.errors.size() ? series.errors[i] : 0;
}

/// Range of the values along each axis; x and y are its coordinates.
using DataRange = Eigen::AlignedBox2d;

/// Extends the range by a point with bars of length `error` above and below it, as far as axes can show them.
void include(double x, double y, double error, const Panel& panel, DataRange& range) {
  if (!can_show(x, panel.x_scale) || !can_show(y, panel.y_scale)) return;
  for (const double y_end : {y, y - error, y + error})
    if (can_show(y_end, panel.y_scale)) range.extend(Eigen::Vector2d(x, y_end));
}

/// Returns the range of the data of a panel: x of all series, and y of the plain series (Emphasis::plain). If
/// the plain series have no points, the range of y includes all series. Throws InputError if there is no
/// point at all.
DataRange data_range(const Panel& panel) {
  DataRange plain, all;
  for (const Series& series : panel.series) {
    DataRange range;
    for (std::size_t i = 0; i < series.x.size(); ++i)
      include(series.x[i], series.y[i], error_at(series, i), panel, range);
    all.extend(range);
    if (series.emphasis == Emphasis::plain) plain.extend(range);
  }
  for (const MapCell& cell : panel.cells) {
    include(cell.x_low, cell.y_low, 0, panel, plain);
    include(cell.x_high, cell.y_high, 0, panel, plain);
  }
  all.extend(plain);
  if (all.isEmpty()) {
    const std::string& value = panel.value_label.quantity;  // of a map
    const bool logarithmic = value.empty() && panel.y_scale == ScaleKind::logarithmic;
    throw InputError(
        "figure",
        fmt::format(
            "there is no point with a {} value of \"{}\" to draw; add files that contain such a value",
            logarithmic ? "positive" : "finite", value.empty() ? panel.y_label.quantity : value));
  }
  if (!plain.isEmpty()) {
    all.min().y() = plain.min().y();
    all.max().y() = plain.max().y();
  }
  return all;
}

AxisScale axis_scale(double low, double high, ScaleKind scale, TickKind ticks) {
  return scale == ScaleKind::linear ? linear_scale(low, high, ticks) : logarithmic_scale(low, high);
}

PlotArea plot_area(const Panel& panel, double top) {
  const DataRange range = data_range(panel);
  return {.top = top,
          .x = axis_scale(range.min().x(), range.max().x(), panel.x_scale, panel.x_ticks),
          .y = axis_scale(range.min().y(), range.max().y(), panel.y_scale, TickKind::any)};
}

/// Returns the text of an axis label with unit, for example "velocity (10⁻⁵ um/s)". The text contains the
/// power of ten by which the tick labels must be multiplied.
std::string label_text(const AxisLabel& label, int exponent) {
  const std::string power = exponent == 0 ? "" : power_of_ten(exponent);
  const std::string gap = power.empty() || label.unit.empty() ? "" : " ";
  const std::string unit = power + gap + label.unit;
  return unit.empty() ? label.quantity : fmt::format("{} ({})", label.quantity, unit);
}

std::string draw_x_axis(const PlotArea& area, const AxisLabel& label) {
  std::string elements;
  for (const auto& [tick, tick_label] : area.x.ticks) {
    const double x = area.at(tick, area.y.low).x;
    elements += svg::line({x, area.top}, {x, area.bottom()}, grid_stroke);
    elements += svg::line({x, area.bottom()}, {x, area.bottom() + tick_length}, frame_stroke);
    elements += svg::text({x, area.bottom() + 18}, tick_label, {tick_size, svg::Anchor::middle});
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
  for (const auto& [tick, tick_label] : area.y.ticks) {
    const double y = area.at(area.x.low, tick).y;
    elements += svg::line({plot_left, y}, {plot_left + plot_width, y}, grid_stroke);
    elements += svg::line({plot_left - tick_length, y}, {plot_left, y}, frame_stroke);
    elements += svg::text({plot_left - tick_length - 4, y + 4}, tick_label, {tick_size, svg::Anchor::end});
  }
  for (const double tick : area.y.minor_ticks) {
    const double y = area.at(area.x.low, tick).y;
    elements += svg::line({plot_left - minor_tick_length, y}, {plot_left, y}, frame_stroke);
  }
  return elements + svg::text({margin + 8, area.top + plot_height / 2}, label_text(label, area.y.exponent),
                              {.size = label_size, .anchor = svg::Anchor::middle, .rotation = -90});
}

svg::Stroke line_stroke(const Series& series) {
  const bool plain = series.emphasis == Emphasis::plain;
  return {.colour = svg::palette[svg::palette_place(series.colour)],
          .width = plain ? line_width : faint_line_width,
          .dashes = dashes[static_cast<std::size_t>(series.dash) % dashes.size()],
          .opacity = plain ? 1.0 : faint_opacity};
}

std::string draw_line(const Series& series, const std::vector<svg::Point>& points) {
  return series.mark == Mark::points ? "" : svg::polyline(points, line_stroke(series));
}

std::string draw_points(const Series& series, const std::vector<svg::Point>& points) {
  std::string elements;
  if (series.mark == Mark::line) return elements;
  const svg::Stroke stroke = line_stroke(series);
  for (const svg::Point& point : points)
    elements += svg::marker(point, series.shape, stroke.colour, stroke.opacity);
  return elements;
}

/// Returns the point on the page, moved to the edge of the plot if it lies above or below.
svg::Point inside_plot(const PlotArea& area, double x, double y) {
  svg::Point point = area.at(x, y);
  point.y = std::isfinite(point.y) ? std::clamp(point.y, area.top, area.bottom()) : area.bottom();
  return point;
}

/// Draws bars at points, or the band along each part of a line without gap.
std::string draw_errors(const PlotArea& area, const Series& series) {
  std::string elements;
  if (series.errors.empty() || series.emphasis == Emphasis::faint) return elements;
  svg::Stroke bar = line_stroke(series);
  bar.width = faint_line_width;
  bar.dashes = "";
  std::vector<svg::Point> upper, lower;
  const auto close_band = [&] {
    if (upper.size() > 1) {
      upper.insert(upper.end(), lower.rbegin(), lower.rend());
      elements += svg::area(upper, bar.colour, 0.15);
    }
    upper.clear();
    lower.clear();
  };
  for (std::size_t i = 0; i < series.x.size(); ++i) {
    const svg::Point point = area.at(series.x[i], series.y[i]);
    if (!std::isfinite(point.x) || !std::isfinite(point.y)) {
      close_band();
      continue;
    }
    const svg::Point high = inside_plot(area, series.x[i], series.y[i] + error_at(series, i));
    const svg::Point low = inside_plot(area, series.x[i], series.y[i] - error_at(series, i));
    if (series.mark == Mark::points) {
      if (high.y < low.y) elements += svg::line(low, high, bar);
    } else {
      upper.push_back(high);
      lower.push_back(low);
    }
  }
  close_band();
  return elements;
}

std::string draw_series(const PlotArea& area, const Series& series) {
  std::vector<svg::Point> points, inside;
  for (std::size_t i = 0; i < series.x.size(); ++i) {
    points.push_back(area.at(series.x[i], series.y[i]));
    if (area.contains(points.back())) inside.push_back(points.back());
  }
  std::string elements = draw_errors(area, series);
  for (const auto& part : svg::visible_parts(points, area.top, area.bottom()))
    elements += draw_line(series, part);
  return elements + draw_points(series, inside);
}

double legend_height(const std::vector<Series>& entries) {
  const auto count = std::ranges::count_if(entries, [](const Series& s) { return !s.label.empty(); });
  return line_pitch * static_cast<double>(count + 1);
}

/// Returns the series of all panels, each label once.
std::vector<Series> common_entries(const std::vector<Panel>& panels) {
  std::vector<Series> entries;
  for (const Emphasis emphasis : {Emphasis::plain, Emphasis::faint}) {
    for (const Panel& panel : panels) {
      for (const Series& series : panel.series)
        if (series.emphasis == emphasis &&
            std::ranges::find(entries, series.label, &Series::label) == entries.end())
          entries.push_back(series);
    }
  }
  return entries;
}

std::string draw_legend(double top, const std::vector<Series>& entries) {
  std::string elements;
  double y = top + 10;
  for (const Series& series : entries) {
    if (series.label.empty()) continue;
    const double right = legend_left + legend_key_width;
    elements += draw_line(series, {{legend_left, y}, {right, y}});
    elements += draw_points(series, {{legend_left + legend_key_width / 2, y}});
    elements += svg::text({right + 8, y + 4}, series.label, {tick_size});
    y += line_pitch;
  }
  return elements;
}

/// Returns a colour from dark blue (0) over green to yellow (1), whose lightness grows evenly. The stops are
/// those of the colour map viridis of Matplotlib (Smith & van der Walt, 2015, CC0).
std::string map_colour(double share) {
  constexpr std::array stops{"#440154", "#472c7a", "#3b518b", "#2c718e", "#21908d",
                             "#27ad81", "#5cc863", "#aadc32", "#fde725"};
  const double place = std::clamp(share, 0.0, 1.0) * (stops.size() - 1);
  const std::size_t before = std::min(static_cast<std::size_t>(place), stops.size() - 2);
  return svg::mixed(stops[before], stops[before + 1], place - static_cast<double>(before));
}

std::pair<double, double> value_range(const Panel& panel) {
  const auto [lowest, highest] = std::ranges::minmax(panel.cells, {}, &MapCell::value);
  return {lowest.value, highest.value};
}

std::string draw_map(const PlotArea& area, const Panel& panel) {
  std::string elements;
  const auto [low, high] = value_range(panel);
  for (const MapCell& cell : panel.cells)
    elements += svg::area({area.at(cell.x_low, cell.y_low), area.at(cell.x_high, cell.y_low),
                           area.at(cell.x_high, cell.y_high), area.at(cell.x_low, cell.y_high)},
                          map_colour(high > low ? (cell.value - low) / (high - low) : 0.5), 1);
  return elements;
}

constexpr double bar_width = 16;  // width of the colour bar [px]

/// Draws the colour bar of a map at its right, with ticks and the name of the value.
std::string draw_colour_bar(const PlotArea& area, const Panel& panel) {
  constexpr int steps = 64;
  constexpr double top_room = 26;
  const auto [low, high] = value_range(panel);
  const double top = area.top + top_room, height = area.bottom() - top;
  const AxisScale scale = linear_scale(low, high, TickKind::any);
  std::string elements = svg::text({legend_left, area.top + 10},
                                   label_text(panel.value_label, scale.exponent), {.size = label_size});
  for (int s = 0; s < steps; ++s) {
    const double upper = top + height * (steps - 1 - s) / steps, lower = upper + height / steps + 0.5;
    elements += svg::area({{legend_left, lower},
                           {legend_left + bar_width, lower},
                           {legend_left + bar_width, upper},
                           {legend_left, upper}},
                          map_colour((s + 0.5) / steps), 1);
  }
  for (const auto& [tick, label] : scale.ticks) {
    if (tick < low || tick > high) continue;
    const double y = high > low ? area.bottom() - height * (tick - low) / (high - low) : top + height / 2;
    elements +=
        svg::line({legend_left + bar_width, y}, {legend_left + bar_width + tick_length, y}, frame_stroke);
    elements += svg::text({legend_left + bar_width + tick_length + 4, y + 4}, label, {tick_size});
  }
  return elements;
}

double title_height(const Panel& panel) {
  return panel.title.empty() ? 0 : 14;
}

std::string draw_panel(const Panel& panel, double top) {
  const PlotArea area = plot_area(panel, top);
  std::string elements = draw_x_axis(area, panel.x_label) + draw_y_axis(area, panel.y_label);
  if (!panel.cells.empty()) elements += draw_map(area, panel) + draw_colour_bar(area, panel);
  elements += svg::rectangle({plot_left, top}, plot_width, plot_height, frame_stroke);
  for (const bool points : {false, true})  // lines are drawn first, so that they do not hide points
    for (const Series& series : panel.series)
      if ((series.mark == Mark::points) == points) elements += draw_series(area, series);
  if (!panel.title.empty())
    elements += svg::text({plot_left, top - 7}, panel.title,
                          {.size = label_size, .anchor = svg::Anchor::start, .weight = "bold"});
  return elements;
}

/// Draws all panels with their legends. Moves `top` to the end of the last panel and legend [px].
std::string draw_panels(const Figure& figure, double& top) {
  std::string elements;
  const double first_top = top + title_height(figure.panels.front());
  for (const Panel& panel : figure.panels) {
    top += title_height(panel);
    elements += draw_panel(panel, top);
    double height = panel_pitch;
    if (!figure.has_common_legend) {
      elements += draw_legend(top, panel.series);
      height = std::max(height, legend_height(panel.series));
    }
    top += height;
  }
  if (figure.has_common_legend) {
    const std::vector<Series> entries = common_entries(figure.panels);
    elements += draw_legend(first_top, entries);
    top = std::max(top, first_top + legend_height(entries));
  }
  return elements;
}

double page_width(const Figure& figure) {
  double right = std::max(plot_left + plot_width, plot_left + svg::text_width(figure.title, title_size));
  for (const Panel& panel : figure.panels) {
    for (const Series& series : panel.series) {
      right = std::max(right, legend_left + legend_key_width + 8 + svg::text_width(series.label, tick_size));
    }
    if (panel.cells.empty()) continue;
    constexpr int likely_exponent = -5;  // exponent of the ticks, for the width of the label
    right = std::max(
        right, legend_left + svg::text_width(label_text(panel.value_label, likely_exponent), label_size));
  }
  return std::ceil(right + margin);
}

std::string fields_of(const AxisLabel& label) {
  return quoted(label.quantity) + "," + quoted(label.unit) + ",";
}

/// Colour, shape, dash, x and y of a point: equal for a point of a curve and the end of its faint part there.
using CsvPoint = std::tuple<int, int, int, double, double>;

/// Returns a line of comma-separated values for each finite point of the series, without those points of a
/// faint series that are in `written`. Adds the points to `written`.
std::string csv_lines(const Panel& panel, const Series& series, std::set<CsvPoint>& written) {
  AxisLabel y_label = panel.y_label;
  if (!panel.title.empty()) y_label.quantity += fmt::format(" ({})", panel.title);
  const std::string names = fields_of(y_label) + fields_of(panel.x_label) +
                            quoted(series.data_label.empty() ? series.label : series.data_label);
  std::string lines;
  for (std::size_t i = 0; i < series.x.size(); ++i) {
    if (!std::isfinite(series.y[i])) continue;
    const bool is_new =
        written.insert({series.colour, series.shape, series.dash, series.x[i], series.y[i]}).second;
    if (!is_new && series.emphasis == Emphasis::faint) continue;
    const bool has_error = error_at(series, i) > 0;  // 0: none is stated
    const std::string error = has_error ? fmt::format("{}", series.errors[i]) : "";
    lines += fmt::format("{},{},{},{}\n", names, series.x[i], series.y[i], error);
  }
  return lines;
}

std::string maps_to_csv(const Figure& figure) {
  std::string lines = "x_name,x_unit,y_name,y_unit,value_name,value_unit,x,y,value\n";
  for (const Panel& panel : figure.panels) {
    const std::string names =
        fields_of(panel.x_label) + fields_of(panel.y_label) + fields_of(panel.value_label);
    for (const MapCell& cell : panel.cells)
      lines += fmt::format("{}{},{},{}\n", names, cell.x, cell.y, cell.value);
  }
  return lines;
}

std::string figure_to_csv(const Figure& figure) {
  const auto has_map = [](const Panel& panel) { return !panel.cells.empty(); };
  if (std::ranges::any_of(figure.panels, has_map)) return maps_to_csv(figure);
  std::string lines = "y_name,y_unit,x_name,x_unit,series,x,y,y_error\n";
  for (const Panel& panel : figure.panels) {
    std::set<CsvPoint> written;
    for (const Emphasis emphasis : {Emphasis::plain, Emphasis::faint}) {
      for (const Series& series : panel.series) {
        if (series.emphasis == emphasis) lines += csv_lines(panel, series, written);
      }
    }
  }
  return lines;
}

}  // namespace

Drawing draw(const Figure& figure) {
  std::string elements = svg::text({plot_left, 30}, figure.title,
                                   {.size = title_size, .anchor = svg::Anchor::start, .weight = "bold"});
  double top = first_plot_top;
  elements += draw_panels(figure, top);
  const double width = page_width(figure);
  const svg::NoteBlock notes = svg::draw_notes(figure.notes, {plot_left, top}, width - plot_left - margin);
  return {.svg = svg::document(width, notes.bottom + margin + line_pitch / 3, figure.title,
                               elements + notes.elements),
          .csv = figure_to_csv(figure)};
}

}  // namespace beadswim
