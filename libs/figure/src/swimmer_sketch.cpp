#include "beadswim/figure/swimmer_sketch.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "beadswim/core/csv.hpp"
#include "plot_area.hpp"

namespace beadswim {
namespace {

// Dimensions of the page [px].
constexpr double margin = 24;
constexpr double max_width = 620,
                 largest_radius = 58;  // maximum width and maximum bead radius of the swimmer
constexpr double forces_height = 44;   // space above the largest bead for horizontal forces
constexpr double lengths_height = 66;  // distance from the largest bead to the notes below
constexpr double force_length = 64, force_gap = 14;
constexpr double line_pitch = 16;
// `arm_offset` is the distance of a spring, and of its dashpot, from the axis of the swimmer.
constexpr double spring_height = 8, dashpot_height = 7, arm_offset = 13;
constexpr int spring_turns = 7;

const std::string bead_fill = "#cfe3f1";
const svg::Stroke bead_stroke{.colour = svg::palette[0], .width = 1.4},
    spring_stroke{.colour = "#333333", .width = 1.4};
const svg::Stroke force_stroke{.colour = svg::palette[1], .width = 2},
    length_stroke{.colour = "#000000", .width = 0.9};
const svg::Stroke witness_stroke{.colour = "#8a8a8a", .width = 0.7},
    axis_stroke{.colour = "#8a8a8a", .width = 0.9, .dashes = "8 3 2 3"};

/// Positions and sizes of the beads on the page [px].
struct PageLayout {
  double scale = 1;  ///< [px/length]
  std::array<svg::Point, 3> centres;
  std::array<double, 3> radii{};
  double top = 0, bottom = 0;  ///< y coordinates of top and bottom of the largest bead [px]

  double end() const { return centres[2].x() + radii[2]; }
};

PageLayout lay_out_page(const SwimmerSketch& sketch) {
  const auto& [first, second] = sketch.rest_lengths;
  const double max_radius = *std::ranges::max_element(sketch.radii);
  PageLayout page;
  page.scale =
      std::min(max_width / (sketch.radii[0] + first + second + sketch.radii[2]), largest_radius / max_radius);
  for (std::size_t b = 0; b < 3; ++b) page.radii[b] = page.scale * sketch.radii[b];
  page.top = 2 * margin + forces_height + force_length * std::abs(std::sin(sketch.force_angle));
  page.bottom = page.top + 2 * page.scale * max_radius;
  const double y = (page.top + page.bottom) / 2, start = margin + std::max(page.radii[0], 60.0);
  page.centres = {svg::Point{start, y}, svg::Point{start + page.scale * first, y},
                  svg::Point{start + page.scale * (first + second), y}};
  return page;
}

/// Draws a spring between the surfaces of two beads. Each of the two straight ends has an eighth of the
/// length of the spring.
std::string draw_spring(svg::Point from, double length) {
  std::vector<svg::Point> points{from, {from.x() + length / 8, from.y()}};
  const double turn = 0.75 * length / spring_turns;
  for (int i = 0; i < spring_turns; ++i) {
    const double x = from.x() + length / 8 + i * turn;
    points.push_back({x + turn / 4, from.y() - spring_height});
    points.push_back({x + 3 * turn / 4, from.y() + spring_height});
  }
  points.push_back({from.x() + 7 * length / 8, from.y()});
  points.push_back({from.x() + length, from.y()});
  return svg::polyline(points, spring_stroke);
}

/// Draws a dashpot: a piston in a cylinder that is open at the right.
std::string draw_dashpot(svg::Point from, double length) {
  const double left = from.x() + 0.36 * length, piston = from.x() + 0.52 * length,
               right = from.x() + 0.64 * length;
  const double up = from.y() - dashpot_height, down = from.y() + dashpot_height;
  return svg::polyline({{right, up}, {left, up}, {left, down}, {right, down}}, spring_stroke) +
         svg::line(from, {left, from.y()}, spring_stroke) +
         svg::line({piston, up + 2}, {piston, down - 2}, spring_stroke) +
         svg::line({piston, from.y()}, {from.x() + length, from.y()}, spring_stroke);
}

/// Returns the distance between the surfaces of the two beads of an arm [px].
double gap(const PageLayout& page, std::size_t arm) {
  return page.centres[arm + 1].x() - page.radii[arm + 1] - page.centres[arm].x() - page.radii[arm];
}

/// Returns true if the labels of springs and dashpots fit between the beads. Otherwise they are drawn below
/// the lengths.
bool labels_fit(const SwimmerSketch& sketch, const PageLayout& page) {
  for (std::size_t arm = 0; arm < 2; ++arm) {
    for (const std::string& label : {sketch.spring_labels[arm], sketch.dashpot_labels[arm]})
      if (svg::text_width(label, label_size) > gap(page, arm)) return false;
  }
  return true;
}

std::string draw_arm(const SwimmerSketch& sketch, const PageLayout& page, std::size_t arm) {
  const svg::Point from{page.centres[arm].x() + page.radii[arm], page.centres[arm].y()};
  const double length = gap(page, arm), middle = from.x() + length / 2;
  const bool damped = !sketch.dashpot_labels[arm].empty();
  const double up = damped ? from.y() - arm_offset : from.y(), down = from.y() + arm_offset;
  const bool inside = labels_fit(sketch, page);
  const double below = page.bottom + lengths_height;
  std::string elements = draw_spring({from.x(), up}, length);
  if (damped) {
    elements += draw_dashpot({from.x(), down}, length);
    for (const double x : {from.x(), from.x() + length})
      elements += svg::line({x, up}, {x, down}, spring_stroke);
    elements += svg::text({middle, inside ? down + dashpot_height + 15 : below + line_pitch},
                          sketch.dashpot_labels[arm], {label_size, svg::Anchor::middle});
  }
  return elements + svg::text({middle, inside ? up - spring_height - 7 : below}, sketch.spring_labels[arm],
                              {label_size, svg::Anchor::middle});
}

/// Draws a bead with its number, a line from its centre to its surface, and the label of its radius below it.
std::string draw_bead(const SwimmerSketch& sketch, const PageLayout& page, std::size_t bead) {
  const svg::Point centre = page.centres[bead];
  const double radius = page.radii[bead], slant = radius * std::sqrt(0.5);
  return svg::disc(centre, radius, bead_fill, bead_stroke) +
         svg::line(centre, {centre.x() + slant, centre.y() + slant}, length_stroke) +
         svg::text({centre.x(), centre.y() - 4}, fmt::format("{}", bead + 1),
                   {.size = std::clamp(radius / 2, 7.0, label_size),
                    .anchor = svg::Anchor::middle,
                    .weight = "bold"}) +
         svg::text({centre.x() + 5, page.bottom + 15}, sketch.radius_labels[bead], {label_size});
}

/// Draws the force above a bead. The force on the middle bead has the opposite direction.
std::string draw_force(const SwimmerSketch& sketch, const PageLayout& page, std::size_t bead) {
  const double sign = bead == 1 ? -1 : 1;
  const svg::Point half =
      sign * force_length / 2 * svg::Point(std::cos(sketch.force_angle), -std::sin(sketch.force_angle));
  const svg::Point middle(page.centres[bead].x(), page.top - force_gap - std::abs(half.y()));
  return svg::arrow(middle - half, middle + half, force_stroke) +
         svg::text({middle.x(), middle.y() - std::abs(half.y()) - 10}, sketch.force_labels[bead],
                   {label_size, svg::Anchor::middle});
}

std::string draw_length(const SwimmerSketch& sketch, const PageLayout& page, std::size_t arm) {
  const double y = page.bottom + 34;
  const svg::Point from{page.centres[arm].x(), y}, to{page.centres[arm + 1].x(), y};
  return svg::double_arrow(from, to, length_stroke) + svg::text((from + to) / 2 + svg::Point(0, 16),
                                                                sketch.length_labels[arm],
                                                                {label_size, svg::Anchor::middle});
}

std::string draw_axis(const PageLayout& page) {
  const double y = page.centres[0].y();
  std::string elements = svg::arrow({page.end(), y}, {page.end() + 46, y}, axis_stroke) +
                         svg::text({page.end() + 52, y + 4}, "axis", {label_size});
  for (const svg::Point& centre : page.centres)
    elements += svg::line(centre, {centre.x(), page.bottom + 38}, witness_stroke);
  return elements;
}

double page_width(const SwimmerSketch& sketch, const PageLayout& page) {
  const double label_end = page.centres[2].x() + svg::text_width(sketch.force_labels[2], label_size) / 2;
  return std::max(page.end() + 90, label_end) + margin;
}

}  // namespace

Drawing draw(const SwimmerSketch& sketch) {
  const PageLayout page = lay_out_page(sketch);
  std::string elements = svg::text({margin, 28}, sketch.title, {.size = title_size, .weight = "bold"});
  elements += draw_axis(page);
  for (std::size_t bead = 0; bead < 3; ++bead)
    elements += draw_bead(sketch, page, bead) + draw_force(sketch, page, bead);
  for (std::size_t arm = 0; arm < 2; ++arm)
    elements += draw_arm(sketch, page, arm) + draw_length(sketch, page, arm);
  const double top = page.bottom + lengths_height + (labels_fit(sketch, page) ? 0 : 2 * line_pitch);
  const double width = page_width(sketch, page);
  const svg::NoteBlock notes = svg::draw_notes(sketch.notes, {margin, top + line_pitch}, width - 2 * margin);
  std::string lines = "bead,x,radius,unit\n";
  double x = 0;
  for (std::size_t b = 0; b < sketch.radii.size(); ++b) {
    if (b > 0) x += sketch.rest_lengths[b - 1];
    lines += fmt::format("{},{},{},{}\n", b + 1, x, sketch.radii[b], quoted(sketch.length_unit));
  }
  return {.svg = svg::document(width, notes.bottom + margin, sketch.title, elements + notes.elements),
          .csv = lines};
}

}  // namespace beadswim
