#include "beadswim/figure/figure.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <tuple>

#include "beadswim/core/csv.hpp"
#include "beadswim/core/error.hpp"
#include "beadswim/core/vec3.hpp"
#include "plot_area.hpp"
#include "svg.hpp"

namespace beadswim {
namespace {

constexpr std::array dashes{"", "6 4", "1.5 3", "8 3 2 3", "13 4", "8 3 2 3 2 3"};
constexpr double line_width = 1.8, faint_line_width = 1.1;
constexpr double faint_opacity = 0.65;

// Dimensions of the page [px].
constexpr double legend_left = plot_left + panel_width + legend_gap;
constexpr double legend_key_width = 30;
constexpr double line_pitch = 18;

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
        "figure", "there is no point with a {} value of \"{}\" to draw; add files that contain such a value",
        logarithmic ? "positive" : "finite", value.empty() ? panel.y_label.quantity : value);
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
  point.y() = std::isfinite(point.y()) ? std::clamp(point.y(), area.top, area.bottom()) : area.bottom();
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
    if (!point.allFinite()) {
      close_band();
      continue;
    }
    const svg::Point high = inside_plot(area, series.x[i], series.y[i] + error_at(series, i));
    const svg::Point low = inside_plot(area, series.x[i], series.y[i] - error_at(series, i));
    if (series.mark == Mark::points) {
      if (high.y() < low.y()) elements += svg::line(low, high, bar);
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

ColourScale colours_of(const Panel& panel) {
  const auto [lowest, highest] = std::ranges::minmax(panel.cells, {}, &MapCell::value);
  return {exact_scale(lowest.value, highest.value, ScaleKind::linear), dark_to_light};
}

std::string draw_map(const PlotArea& area, const Panel& panel) {
  std::string elements;
  const ColourScale scale = colours_of(panel);
  for (const MapCell& cell : panel.cells)
    elements += svg::filled_rectangle(area.at(cell.x_low, cell.y_low), area.at(cell.x_high, cell.y_high),
                                      scale.colour(scale.share_of(cell.value)));
  return elements + draw_colour_bar({area.legend_left(), area.top}, area.height, scale, panel.value_label);
}

double title_height(const Panel& panel) {
  return panel.title.empty() ? 0 : 14;
}

std::string draw_panel(const Panel& panel, double top) {
  const PlotArea area = plot_area(panel, top);
  std::string elements = draw_x_axis(area, panel.x_label) + draw_y_axis(area, panel.y_label);
  if (!panel.cells.empty()) elements += draw_map(area, panel);
  elements += svg::rectangle({plot_left, top}, area.width, area.height, frame_stroke);
  for (const bool points : {false, true})  // lines are drawn first, so that they do not hide points
    for (const Series& series : panel.series)
      if ((series.mark == Mark::points) == points) elements += draw_series(area, series);
  if (!panel.title.empty())
    elements += svg::text({plot_left, top - 7}, panel.title, {.size = label_size, .weight = "bold"});
  return elements;
}

/// Draws all panels with their legends. Moves `top` to the end of the last panel and legend [px].
std::string draw_panels(const Figure& figure, double& top) {
  std::string elements;
  const double first_top = top + title_height(figure.panels.front());
  for (const Panel& panel : figure.panels) {
    top += title_height(panel);
    elements += draw_panel(panel, top);
    double height = panel_height + below_plot;
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
  double right = std::max(plot_left + panel_width, plot_left + svg::text_width(figure.title, title_size));
  for (const Panel& panel : figure.panels) {
    for (const Series& series : panel.series) {
      right = std::max(right, legend_left + legend_key_width + 8 + svg::text_width(series.label, tick_size));
    }
    if (panel.cells.empty()) continue;
    right = std::max(right, legend_left + colour_bar_width(panel.value_label));
  }
  return std::ceil(right + page_margin);
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
  std::string elements = svg::text({plot_left, 30}, figure.title, {.size = title_size, .weight = "bold"});
  double top = plot_top;
  elements += draw_panels(figure, top);
  const double width = page_width(figure);
  const svg::NoteBlock notes =
      svg::draw_notes(figure.notes, {plot_left, top}, width - plot_left - page_margin);
  return {.svg = svg::document(width, notes.bottom + page_margin + line_pitch / 3, figure.title,
                               elements + notes.elements),
          .csv = figure_to_csv(figure)};
}

}  // namespace beadswim
