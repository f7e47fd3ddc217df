#include "beadswim/figure/flow_picture.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <map>

#include "beadswim/core/csv.hpp"
#include "beadswim/core/error.hpp"
#include "flow_sampler.hpp"
#include "plot_area.hpp"

namespace beadswim {
namespace {

// Dimensions of the page [px].
constexpr double max_width = 560, max_height = 440;
constexpr double pixel = 2;             // edge of the squares of the map
constexpr int colour_steps = 40;        // of the map
constexpr double min_bar_height = 120;  // of the colour bar with its name
constexpr double line_distance = 18;    // between streamlines
constexpr double head_distance = 150;   // between arrow heads of a streamline
constexpr double arrow_distance = 20;   // between arrows; also the length of the longest one
constexpr double min_tick_distance_x = 44, min_tick_distance_y = 18;
const svg::Stroke line_stroke{.colour = "#202020", .width = 0.9};
const svg::Stroke cut_stroke{.colour = "#000000", .width = 1.3},
    projected_stroke{.colour = "#000000", .width = 1, .dashes = "3 2.5"};
constexpr const char* covered_colour = "#b4b4b4";

/// The part of the speed, relative to the largest, below which the fluid is at rest.
constexpr double rest = 1e-6;

/// Returns a colour from white (0) to dark blue (1).
std::string light_to_dark(double share) {
  constexpr std::array stops{"#f7fbff", "#deebf7", "#c6dbef", "#9ecae1", "#6baed6", "#4292c6", "#2171b5"};
  return colour_between(stops, share);
}

/// Returns a colour from blue (0) over white to red (1).
std::string blue_to_red(double share) {
  constexpr std::array stops{"#2166ac", "#4393c3", "#92c5de", "#d1e5f0", "#f7f7f7",
                             "#fddbc7", "#f4a582", "#d6604d", "#b2182b"};
  return colour_between(stops, share);
}

double value_of(const Vec3& velocity, FlowQuantity quantity) {
  return quantity == FlowQuantity::speed ? velocity.norm() : velocity[static_cast<int>(quantity) - 1];
}

AxisLabel label_of(const FlowPicture& picture) {
  return {to_text(picture.quantity), picture.velocity_unit};
}

/// Returns a scale for the values in all cells. That of a speed is logarithmic if the values span decades;
/// the slowest cells, those around stagnation points, then have the colour of its lower end.
ColourScale colours_for(std::vector<double> values, FlowQuantity quantity) {
  constexpr double slowest = 0.05, few_decades = 50;  // part of the cells; largest speed relative to theirs
  std::ranges::sort(values);
  const double low = values[static_cast<std::size_t>(slowest * static_cast<double>(values.size()))];
  const double high = std::max(std::abs(values.front()), std::abs(values.back()));
  if (quantity != FlowQuantity::speed) return {exact_scale(-high, high, ScaleKind::linear), blue_to_red};
  if (low > 0 && high > few_decades * low)
    return {exact_scale(low, high, ScaleKind::logarithmic), light_to_dark};
  return {exact_scale(0, high, ScaleKind::linear), light_to_dark};
}

/// Draws a FlowPicture.
class FlowPainter {
 public:
  explicit FlowPainter(const FlowPicture& picture) : picture_(picture), flow_(picture.layers) {
    const Eigen::AlignedBox2d& region = flow_.region();
    scale_ = std::min(max_width / region.sizes().x(), max_height / region.sizes().y());
    const auto whole_pixels = [&](double length) {
      return pixel * std::max(1.0, std::round(length * scale_ / pixel));
    };
    area_ = {.top = plot_top,
             .width = whole_pixels(region.sizes().x()),
             .height = whole_pixels(region.sizes().y()),
             .x = exact_scale(region.min().x(), region.max().x(), ScaleKind::linear),
             .y = exact_scale(region.min().y(), region.max().y(), ScaleKind::linear)};
    thin_ticks(area_.x, area_.width, min_tick_distance_x);
    thin_ticks(area_.y, area_.height, min_tick_distance_y);
    std::vector<double> values;
    for (const FlowLayer& layer : picture.layers) {
      for (std::size_t n = 0; n < layer.velocity.size(); ++n) {
        if (layer.is_hidden(n)) continue;
        values.push_back(value_of(layer.velocity[n], picture.quantity));
        max_speed_ = std::max(max_speed_, in_plane(layer.velocity[n]).norm());
      }
    }
    if (values.empty())
      throw InputError("figure", "the plane has no cell that shows the flow; give another plane");
    colours_ = colours_for(std::move(values), picture.quantity);
  }

  Drawing drawing() const {
    const std::string unit = picture_.length_unit;
    const auto [right, up] = picture_.axes();
    const double bar_bottom = area_.top + min_bar_height;
    const double width = std::ceil(
        page_margin +
        std::max(area_.legend_left() +
                     std::max(90.0, svg::text_width(label_text(label_of(picture_), colours_.values.exponent),
                                                    label_size)),
                 plot_left + svg::text_width(picture_.title, title_size)));
    std::string elements = svg::text({plot_left, 30}, picture_.title, {.size = title_size, .weight = "bold"});
    elements += draw_x_axis(area_, {std::string(1, "xyz"[right]), unit}) +
                draw_y_axis(area_, {std::string(1, "xyz"[up]), unit});
    elements += draw_map();
    elements += fmt::format(
        "<clipPath id=\"plot\">{}</clipPath>\n<g clip-path=\"url(#plot)\">\n",
        svg::filled_rectangle({plot_left, area_.top}, {plot_left + area_.width, area_.bottom()}, "#ffffff"));
    elements += picture_.style == FlowStyle::streamlines ? draw_streamlines() : draw_arrows();
    if (picture_.shows_covered_cells) elements += draw_covered_cells();
    elements += draw_beads() + "</g>\n";
    elements += svg::rectangle({plot_left, area_.top}, area_.width, area_.height, frame_stroke);
    elements += draw_colour_bar({area_.legend_left(), area_.top}, std::max(area_.height, min_bar_height),
                                colours_, label_of(picture_));
    const svg::NoteBlock notes =
        svg::draw_notes(picture_.notes, {plot_left, std::max(area_.bottom() + below_plot, bar_bottom + 24)},
                        width - plot_left - page_margin);
    return {
        .svg = svg::document(width, notes.bottom + page_margin, picture_.title, elements + notes.elements),
        .csv = numbers()};
  }

 private:
  /// Removes every second tick until they have room.
  static void thin_ticks(AxisScale& scale, double length, double min_distance) {
    while (scale.ticks.size() > 1 &&
           length * (scale.fraction(scale.ticks[1].value) - scale.fraction(scale.ticks[0].value)) <
               min_distance) {
      std::size_t n = 0;
      std::erase_if(scale.ticks, [&](const Tick&) { return n++ % 2 == 1; });
    }
  }

  PlanePoint in_plane(const Vec3& velocity) const {
    const auto [right, up] = picture_.axes();
    return {velocity[right], velocity[up]};
  }

  svg::Point on_page(const PlanePoint& place) const { return area_.at(place.x(), place.y()); }

  /// Calls visit(x, y, place) for the centres of squares that fill the plot: row by row, from the top.
  template <class Visit>
  void for_each_pixel(const Visit& visit) const {
    const Eigen::AlignedBox2d& region = flow_.region();
    for (double y = pixel / 2; y < area_.height; y += pixel)
      for (double x = pixel / 2; x < area_.width; x += pixel) {
        const PlanePoint share(x / area_.width, 1 - y / area_.height);
        visit(plot_left + x, area_.top + y, region.min() + region.sizes().cwiseProduct(share));
      }
  }

  /// Returns the areas of each colour as one path of horizontal strokes. `colour_at`: number of the colour at
  /// a place, negative for none; `colour`: the colour with a number.
  template <class ColourAt, class Colour>
  std::string painted(const ColourAt& colour_at, const Colour& colour) const {
    std::map<int, std::string> paths;
    int present = -1;
    double row = 0, start = 0, end = 0;
    const auto finish_run = [&] {
      if (present >= 0) paths[present] += fmt::format("M{:g} {:g}L{:g} {:g}", start, row, end, row);
    };
    for_each_pixel([&](double x, double y, const PlanePoint& place) {
      const int number = colour_at(place);
      if (y != row || number != present) {
        finish_run();
        present = number;
        row = y;
        start = x - pixel / 2;
      }
      end = x + pixel / 2;
    });
    finish_run();
    std::string elements =
        fmt::format("<g fill=\"none\" stroke-width=\"{:g}\" shape-rendering=\"crispEdges\">\n", pixel);
    for (const auto& [number, path] : paths)
      elements += fmt::format("<path stroke=\"{}\" d=\"{}\"/>\n", colour(number), path);
    return elements + "</g>\n";
  }

  std::string draw_map() const {
    return painted(
        [&](const PlanePoint& place) {
          const double share = colours_.share_of(value_of(flow_.velocity(place), picture_.quantity));
          return std::min(static_cast<int>(share * colour_steps), colour_steps - 1);
        },
        [&](int step) { return colours_.colour((step + 0.5) / colour_steps); });
  }

  std::string draw_covered_cells() const {
    return painted([&](const PlanePoint& place) { return flow_.covered(place) >= 0.5 ? 0 : -1; },
                   [](int) { return covered_colour; });
  }

  std::string draw_streamlines() const {
    const PlaneVelocity velocity = [&](const PlanePoint& place) {
      const PlanePoint along = in_plane(flow_.velocity(place));
      return along.norm() < rest * max_speed_ ? PlanePoint(0, 0) : along;
    };
    std::string elements;
    for (const Streamline& line : streamlines(velocity, flow_.region(), line_distance / scale_)) {
      std::vector<svg::Point> points;
      for (std::size_t n = 0; n < line.size(); ++n)
        if (n % 2 == 0 || n + 1 == line.size()) points.push_back(on_page(line[n]));
      elements += svg::polyline(points, line_stroke);
      const double per_step = line_distance / 10, length = per_step * static_cast<double>(line.size());
      const int heads = std::max(1, static_cast<int>(std::lround(length / head_distance)));
      for (int h = 0; h < heads; ++h) {
        const auto n = static_cast<std::size_t>((h + 0.5) / heads * static_cast<double>(line.size() - 1));
        elements += svg::arrow_head(on_page(line[n]), on_page(line[n + 1]), line_stroke.colour, 6);
      }
    }
    return elements;
  }

  std::string draw_arrows() const {
    std::string elements;
    const int columns = std::max(1, static_cast<int>(area_.width / arrow_distance)),
              rows = std::max(1, static_cast<int>(area_.height / arrow_distance));
    for (int n = 0; n < columns * rows; ++n) {
      const PlanePoint share((n % columns + 0.5) / columns, (n / columns + 0.5) / rows);
      const PlanePoint place = flow_.region().min() + flow_.region().sizes().cwiseProduct(share);
      const PlanePoint along = in_plane(flow_.velocity(place));
      const double length = arrow_distance * std::sqrt(along.norm() / max_speed_);
      if (!(length > 2)) continue;
      const svg::Point half = length / 2 * svg::Point(along.x(), -along.y()).normalized(),
                       middle = on_page(place);
      const double head = std::clamp(0.4 * length, 2.5, 6.0);
      elements += svg::line(middle - half, middle + half - 0.5 * head * half.normalized(), line_stroke) +
                  svg::arrow_head(middle - half, middle + half, line_stroke.colour, head);
    }
    return elements;
  }

  std::string draw_beads() const {
    std::string elements;
    for (const bool is_cut : {true, false})
      for (const BeadOutline& bead : picture_.beads)
        if (bead.is_cut == is_cut)
          elements += svg::disc(on_page(bead.centre), bead.radius * scale_, is_cut ? "#e8e8e8" : "none",
                                is_cut ? cut_stroke : projected_stroke);
    return elements;
  }

  std::string numbers() const {
    std::string lines = "x,y,z,ux,uy,uz,length_unit,velocity_unit\n";
    const auto [right, up] = picture_.axes();
    for (const FlowLayer& layer : picture_.layers)
      for (int y = 0; y < layer.cells.y(); ++y)
        for (int x = 0; x < layer.cells.x(); ++x) {
          const std::size_t n = layer.index(x, y);
          if (layer.is_hidden(n)) continue;
          Vec3 place = Vec3::Constant(picture_.coordinate);
          place[right] = layer.centre(x, y).x();
          place[up] = layer.centre(x, y).y();
          const Vec3& u = layer.velocity[n];
          lines += fmt::format("{},{},{},{},{},{},{},{}\n", place.x(), place.y(), place.z(), u.x(), u.y(),
                               u.z(), quoted(picture_.length_unit), quoted(picture_.velocity_unit));
        }
    return lines;
  }

  const FlowPicture& picture_;
  FlowSampler flow_;
  double scale_ = 1;  ///< [px/length]
  PlotArea area_;
  double max_speed_ = 0;  ///< of the velocity in the plane [length/time]
  ColourScale colours_;
};

}  // namespace

Drawing draw(const FlowPicture& picture) {
  return FlowPainter(picture).drawing();
}

}  // namespace beadswim
