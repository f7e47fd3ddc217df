#include "plot_area.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>

namespace beadswim {
namespace {

constexpr double tick_length = 5, minor_tick_length = 3;  // [px]
const svg::Stroke grid_stroke{.colour = "#e4e4e4", .width = 0.8};

}  // namespace

std::string label_text(const AxisLabel& label, int exponent) {
  const std::string power = exponent == 0 ? "" : power_of_ten(exponent);
  const std::string gap = power.empty() || label.unit.empty() ? "" : " ";
  const std::string unit = power + gap + label.unit;
  return unit.empty() ? label.quantity : fmt::format("{} ({})", label.quantity, unit);
}

std::string draw_x_axis(const PlotArea& area, const AxisLabel& label) {
  std::string elements;
  for (const auto& [tick, tick_label] : area.x.ticks) {
    const double x = area.at(tick, area.y.low).x();
    elements += svg::line({x, area.top}, {x, area.bottom()}, grid_stroke);
    elements += svg::line({x, area.bottom()}, {x, area.bottom() + tick_length}, frame_stroke);
    elements += svg::text({x, area.bottom() + 18}, tick_label, {tick_size, svg::Anchor::middle});
  }
  for (const double tick : area.x.minor_ticks) {
    const double x = area.at(tick, area.y.low).x();
    elements += svg::line({x, area.bottom()}, {x, area.bottom() + minor_tick_length}, frame_stroke);
  }
  return elements + svg::text({plot_left + area.width / 2, area.bottom() + 38},
                              label_text(label, area.x.exponent), {label_size, svg::Anchor::middle});
}

std::string draw_y_axis(const PlotArea& area, const AxisLabel& label) {
  std::string elements;
  for (const auto& [tick, tick_label] : area.y.ticks) {
    const double y = area.at(area.x.low, tick).y();
    elements += svg::line({plot_left, y}, {plot_left + area.width, y}, grid_stroke);
    elements += svg::line({plot_left - tick_length, y}, {plot_left, y}, frame_stroke);
    elements += svg::text({plot_left - tick_length - 4, y + 4}, tick_label, {tick_size, svg::Anchor::end});
  }
  for (const double tick : area.y.minor_ticks) {
    const double y = area.at(area.x.low, tick).y();
    elements += svg::line({plot_left - minor_tick_length, y}, {plot_left, y}, frame_stroke);
  }
  return elements + svg::text({page_margin + 8, area.top + area.height / 2},
                              label_text(label, area.y.exponent),
                              {.size = label_size, .anchor = svg::Anchor::middle, .rotation = -90});
}

double ColourScale::share_of(double value) const {
  return values.high > values.low ? std::clamp(values.fraction(value), 0.0, 1.0) : 0.5;
}

/// The stops are those of the colour map viridis of Matplotlib (Smith & van der Walt, 2015, CC0).
std::string dark_to_light(double share) {
  constexpr std::array stops{"#440154", "#472c7a", "#3b518b", "#2c718e", "#21908d",
                             "#27ad81", "#5cc863", "#aadc32", "#fde725"};
  return colour_between(stops, share);
}

std::string draw_colour_bar(svg::Point top_left, double total_height, const ColourScale& scale,
                            const AxisLabel& label) {
  constexpr int steps = 64;
  constexpr double top_room = 26, bar_width = 16;  // [px]
  const double left = top_left.x(), right = left + bar_width, top = top_left.y() + top_room;
  const double height = total_height - top_room, bottom = top + height;
  std::string elements =
      svg::text({left, top_left.y() + 10}, label_text(label, scale.values.exponent), {.size = label_size});
  for (int s = 0; s < steps; ++s) {
    const double upper = top + height * (steps - 1 - s) / steps, lower = upper + height / steps + 0.5;
    elements += svg::filled_rectangle({left, lower}, {right, upper}, scale.colour((s + 0.5) / steps));
  }
  const auto height_of = [&](double value) { return bottom - height * scale.share_of(value); };
  for (const double tick : scale.values.minor_ticks)
    elements +=
        svg::line({right, height_of(tick)}, {right + minor_tick_length, height_of(tick)}, frame_stroke);
  for (const auto& [tick, text] : scale.values.ticks) {
    const double y = height_of(tick);
    elements += svg::line({right, y}, {right + tick_length, y}, frame_stroke);
    elements += svg::text({right + tick_length + 4, y + 4}, text, {tick_size});
  }
  return elements;
}

double colour_bar_width(const AxisLabel& label) {
  constexpr int likely_exponent = -5;  // of the ticks
  return svg::text_width(label_text(label, likely_exponent), label_size);
}

}  // namespace beadswim
