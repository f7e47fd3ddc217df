#include "beadswim/figure/swarm_picture.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "beadswim/core/csv.hpp"
#include "beadswim/core/error.hpp"
#include "perspective.hpp"
#include "plot_area.hpp"

namespace beadswim {
namespace {

// Dimensions of the page [px], unless stated otherwise.
constexpr double scale_bar_room = 16;  // below the box [px]
constexpr double picture_top = 44, picture_width = 720, picture_height = 560;
constexpr double line_pitch = 16;
constexpr double bond_width = 0.26;  // relative to reference_radius()
constexpr double mark_size = 17, halo = 3.5;
const svg::Stroke edge_stroke{.colour = "#8a8a8a", .width = 0.8};
const svg::Stroke hidden_edge_stroke{.colour = "#bdbdbd", .width = 0.8, .dashes = "3 3"};
const svg::Stroke distance_stroke{.colour = "#000000", .width = 1.1},
    witness_stroke{.colour = "#000000", .width = 0.6};

/// SVG element of a bead or a bond, with the depth at which it is drawn.
struct Piece {
  double depth = 0;  ///< [length]
  std::string element;
};

/// Colours of the swimmers of a picture: those of the palette or, if colours show values, those of the map
/// and grey.
class SwimmerColours {
 public:
  explicit SwimmerColours(const SwarmPicture& picture)
      : shows_values_(!picture.value_label.quantity.empty()) {
    if (!shows_values_) {
      colours_.assign(svg::palette.begin(), svg::palette.end());
      return;
    }
    for (int i = 0; i < shades; ++i) colours_.push_back(dark_to_light(static_cast<double>(i) / (shades - 1)));
    colours_.emplace_back("#bbbbbb");
    std::vector<double> values;
    for (const PicturedSwimmer& swimmer : picture.swimmers)
      if (swimmer.value) values.push_back(*swimmer.value);
    if (values.empty()) return;
    const auto [low, high] = std::ranges::minmax(values);
    scale_ = {exact_scale(low, high, ScaleKind::linear), dark_to_light};
  }

  const std::vector<std::string>& all() const { return colours_; }
  /// Returns the index of the colour of a swimmer.
  std::size_t place_of(const PicturedSwimmer& swimmer) const {
    if (!shows_values_) return svg::palette_place(swimmer.colour);
    if (!swimmer.value) return shades;
    return static_cast<std::size_t>(std::lround(scale_->share_of(*swimmer.value) * (shades - 1)));
  }
  /// Draws the bar of the values; empty if there are none.
  std::string bar(const SwarmPicture& picture, svg::Point top_left, double height) const {
    return scale_ ? draw_colour_bar(top_left, height, *scale_, picture.value_label) : "";
  }

 private:
  static constexpr int shades = 32;
  bool shows_values_;
  std::vector<std::string> colours_;
  std::optional<ColourScale> scale_;  ///< nullopt: there are no values
};

/// Returns the element of a bead. Numbers have only one decimal, because a swarm has many beads and the
/// document should be small.
std::string bead_element(svg::Point centre, double radius, std::size_t colour) {
  return fmt::format("<circle class=\"b{}\" cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"{:.1f}\"/>\n", colour, centre.x(),
                     centre.y(), radius);
}

Piece bead_piece(const Perspective& view, const PicturedBead& bead, std::size_t colour) {
  return {view.depth(bead.centre),
          bead_element(view.project(bead.centre), view.projected_size(bead.centre, bead.radius), colour)};
}

/// Returns the element of a bond. The bond ends at the surfaces of its beads, on the sides that face each
/// other.
Piece bond_piece(const Perspective& view, const PicturedBead& first, const PicturedBead& second) {
  const Vec3 along = (second.centre - first.centre).normalized();
  const Vec3 from = first.centre + first.radius * along;
  const Vec3 to = second.centre - second.radius * along;
  const svg::Point a = view.project(from), b = view.project(to);
  return {view.depth((from + to) / 2),
          fmt::format("<path d=\"M{:.1f} {:.1f}L{:.1f} {:.1f}\"/>\n", a.x(), a.y(), b.x(), b.y())};
}

/// Foremost point of a swimmer along its axis, and tip of the triangle there, whose height is the radius of
/// the foremost bead.
struct Head {
  Vec3 base, tip;
};

Head head_of(const PicturedSwimmer& swimmer) {
  Vec3 middle = Vec3::Zero();
  for (const PicturedBead& bead : swimmer.beads)
    middle += bead.centre / static_cast<double>(swimmer.beads.size());
  const auto reach = [&](const PicturedBead& bead) { return bead.centre.dot(swimmer.axis) + bead.radius; };
  const PicturedBead& foremost = *std::ranges::max_element(swimmer.beads, {}, reach);
  const Vec3 base = middle + (reach(foremost) - middle.dot(swimmer.axis)) * swimmer.axis;
  return {.base = base, .tip = base + 1.6 * foremost.radius * swimmer.axis};
}

/// Returns the triangle in front of a swimmer.
Piece head_piece(const Perspective& view, const PicturedSwimmer& swimmer, std::size_t colour) {
  const auto [base, tip] = head_of(swimmer);
  const svg::Point a = view.project(base), b = view.project(tip);
  const double half_width = view.projected_size(base, 0.45 * (tip - base).norm());
  const svg::Point along = (b - a).normalized(), side = half_width * svg::Point(-along.y(), along.x());
  const svg::Point left = a + side, right = a - side;
  return {view.depth(tip),
          fmt::format("<polygon class=\"b{}\" points=\"{:.1f},{:.1f} {:.1f},{:.1f} {:.1f},{:.1f}\"/>\n",
                      colour, b.x(), b.y(), left.x(), left.y(), right.x(), right.y())};
}

/// Draws all beads, bonds and heads in order of decreasing depth, so that near elements hide far elements.
std::string draw_swimmers(const SwarmPicture& picture, const SwimmerColours& colours,
                          const Perspective& view) {
  std::vector<Piece> pieces;
  for (const PicturedSwimmer& swimmer : picture.swimmers) {
    const std::size_t colour = colours.place_of(swimmer);
    for (const PicturedBead& bead : swimmer.beads) pieces.push_back(bead_piece(view, bead, colour));
    if (!swimmer.axis.isZero(0)) pieces.push_back(head_piece(view, swimmer, colour));
    for (const auto& [first, second] : swimmer.bonds)
      pieces.push_back(bond_piece(view, swimmer.beads[first], swimmer.beads[second]));
  }
  std::ranges::stable_sort(pieces, std::ranges::greater(), &Piece::depth);
  std::string elements = "<g class=\"s\" fill=\"none\">\n";
  for (const Piece& piece : pieces) elements += piece.element;
  return elements + "</g>\n";
}

/// Returns the gradients that shade each colour, with light from the upper left, and the
/// styles of beads and bonds.
std::string definitions(const std::vector<std::string>& colours, double bond_stroke, double outline) {
  std::string gradients, fills;
  for (std::size_t i = 0; i < colours.size(); ++i) {
    gradients += fmt::format(
        "<radialGradient id=\"g{}\" cx=\"0.36\" cy=\"0.32\" r=\"0.72\"><stop offset=\"0\" stop-color=\"{}\"/>"
        "<stop offset=\"0.45\" stop-color=\"{}\"/><stop offset=\"1\" stop-color=\"{}\"/></radialGradient>\n",
        i, svg::mixed(colours[i], "#ffffff", 0.62), colours[i], svg::mixed(colours[i], "#000000", 0.42));
    fills += fmt::format(".b{0}{{fill:url(#g{0})}}", i);
  }
  return fmt::format(
      "<defs>\n{}<style>{} .s circle,.s polygon{{stroke:#222222;stroke-width:{:.2f}}} "
      ".s path{{stroke:#6e6e6e;stroke-width:{:.2f};stroke-linecap:butt}}</style>\n</defs>\n",
      gradients, fills, outline, bond_stroke);
}

/// Draws edges of the box. If `hidden` is true, draws the three edges that start at the corner farthest from
/// the eye, which are behind the swarm. Otherwise draws the other nine edges.
std::string draw_edges(const SwarmPicture& picture, const Perspective& view, bool hidden) {
  const auto corner = [&](int index) {
    return Block(Vec3::Zero(), picture.box).corner(Block::CornerType(index));
  };
  int far = 0;
  for (int index = 1; index < 8; ++index)
    if (view.depth(corner(far)) < view.depth(corner(index))) far = index;
  std::string elements;
  for (int from = 0; from < 8; ++from) {
    for (const int axis : {1, 2, 4}) {  // bit of the index of a corner
      const int to = from | axis;
      if (to == from || (from == far || to == far) != hidden) continue;
      elements += svg::line(view.project(corner(from)), view.project(corner(to)),
                            hidden ? hidden_edge_stroke : edge_stroke);
    }
  }
  return elements;
}

/// Draws the names of the axes at the midpoints of three edges of the outline, where there are few beads.
std::string draw_axis_names(const SwarmPicture& picture, const Perspective& view) {
  const Vec3& box = picture.box;
  const auto name = [&](const char* axis, const Vec3& middle, const svg::Point& shift) {
    return svg::text(view.project(middle) + shift, axis, {label_size, svg::Anchor::middle});
  };
  return name("x", {box.x() / 2, box.y(), box.z()}, {0, -8}) +
         name("y", {0, box.y() / 2, box.z()}, {-8, -8}) + name("z", {0, 0, box.z() / 2}, {-10, 4});
}

/// Draws the marks above their beads.
std::string draw_marks(const SwarmPicture& picture, const Perspective& view) {
  std::string elements;
  for (const PictureMark& mark : picture.marks) {
    const svg::Point above(0, view.projected_size(mark.bead.centre, mark.bead.radius) + 4);
    elements += svg::text(view.project(mark.bead.centre) - above, mark.name,
                          {.size = mark_size, .anchor = svg::Anchor::middle, .weight = "bold", .halo = halo});
  }
  return elements;
}

/// Draws a distance with its label. The label of a steep arrow is at its right. The label of an approximately
/// horizontal arrow is above or below the arrow, on the side away from the beads.
std::string draw_distance(const PictureDistance& distance, const Perspective& view) {
  const Vec3 from = distance.from + distance.arrow_offset, to = distance.to + distance.arrow_offset;
  const svg::Point a = view.project(from), b = view.project(to), bead = view.project(distance.from);
  std::string elements = svg::line(bead, a, witness_stroke) +
                         svg::line(view.project(distance.to), b, witness_stroke) +
                         svg::double_arrow(a, b, distance_stroke);
  const bool level = std::abs(b.x() - a.x()) > 3 * std::abs(b.y() - a.y());
  const svg::Point shift = level ? svg::Point(0, a.y() > bead.y() ? 1.3 : -0.5) : svg::Point(0.6, 0.6);
  return elements +
         svg::formula(
             (a + b) / 2 + label_size * shift, distance.label,
             {.size = label_size, .anchor = level ? svg::Anchor::middle : svg::Anchor::start, .halo = halo});
}

/// Returns the largest of the numbers 1, 2 and 5 times a power of ten that is at most `limit`.
double round_length(double limit) {
  const double power = std::pow(10, std::floor(std::log10(limit)));
  return limit >= 5 * power ? 5 * power : limit >= 2 * power ? 2 * power : power;
}

/// Draws a bar below the lower front edge of the box, with its length there.
std::string draw_scale_bar(const SwarmPicture& picture, const Perspective& view) {
  const svg::Point below(0, 12), half_end(0, 3);  // [px]
  const double length = round_length(picture.box.x() / 4);
  const svg::Point a = view.project(Vec3::Zero()) + below, b = view.project({length, 0, 0}) + below;
  std::string elements = svg::line(a, b, distance_stroke);
  for (const svg::Point& end : {a, b}) elements += svg::line(end - half_end, end + half_end, distance_stroke);
  return elements + svg::text({a.x(), b.y() + label_size + 3},
                              fmt::format("{:g} {}", length, picture.length_unit),
                              {.size = label_size, .halo = halo});
}

std::string draw_keys(const SwarmPicture& picture, double top) {
  std::string elements;
  double x = page_margin + 6;
  for (std::size_t colour = 0; colour < picture.keys.size(); ++colour) {
    elements += bead_element({x, top - 4}, 6, svg::palette_place(static_cast<int>(colour)));
    elements += svg::text({x + 12, top}, picture.keys[colour], {label_size});
    x += 12 + svg::text_width(picture.keys[colour], label_size) + 20;
  }
  return elements;
}

/// Returns the block that contains the box, all beads, and space for the distance arrows with their labels.
Block extent_of(const SwarmPicture& picture) {
  Block block(Vec3::Zero(), picture.box);
  for (const PicturedSwimmer& swimmer : picture.swimmers) {
    for (const PicturedBead& bead : swimmer.beads) {
      const Vec3 radius = Vec3::Constant(bead.radius);
      block.extend(bead.centre - radius).extend(bead.centre + radius);
    }
    if (!swimmer.axis.isZero(0)) block.extend(head_of(swimmer).tip);
  }
  for (const PictureDistance& distance : picture.distances)
    for (const Vec3& bead : {distance.from, distance.to}) block.extend(bead + 2 * distance.arrow_offset);
  return block;
}

/// Returns the space beside the swarm for the widest distance label, or for the colour bar [px].
double label_room(const SwarmPicture& picture) {
  double room =
      picture.value_label.quantity.empty() ? 0 : colour_bar_width(picture.value_label) + page_margin;
  for (const PictureDistance& distance : picture.distances)
    room = std::max(room, svg::text_width(distance.label, label_size));
  return room;
}

/// Returns the radius to which the widths of lines are proportional: that of the first bead of a swimmer with
/// bonds, or, without such a swimmer, of the first bead [length].
double reference_radius(const SwarmPicture& picture) {
  const auto has_bonds = [](const PicturedSwimmer& swimmer) { return !swimmer.bonds.empty(); };
  const auto found = std::ranges::find_if(picture.swimmers, has_bonds);
  return (found == picture.swimmers.end() ? picture.swimmers.front() : *found).beads.front().radius;
}

std::string beads_to_csv(const SwarmPicture& picture) {
  const bool has_values = !picture.value_label.quantity.empty();
  std::string lines = "swimmer,bead,x,y,z,radius,unit" +
                      (has_values ? "," + quoted(label_text(picture.value_label, 0)) : "") + "\n";
  for (const PicturedSwimmer& swimmer : picture.swimmers) {
    for (std::size_t b = 0; b < swimmer.beads.size(); ++b) {
      const Vec3 place = swimmer.beads[b].centre + picture.origin;
      lines += fmt::format("{},{},{},{},{},{},{}", swimmer.id, b + 1, place.x(), place.y(), place.z(),
                           swimmer.beads[b].radius, quoted(picture.length_unit));
      if (has_values) lines += swimmer.value ? fmt::format(",{}", *swimmer.value) : ",";
      lines += "\n";
    }
  }
  return lines;
}

}  // namespace

Drawing draw(const SwarmPicture& picture) {
  if (picture.swimmers.empty())
    throw InputError("figure",
                     "there is no swimmer to draw; give a layout or a trajectory that contains swimmers");
  const Perspective view(extent_of(picture), {page_margin, picture_top}, picture_width, picture_height);
  const double radius = view.projected_size(picture.box / 2, reference_radius(picture));
  const double width = std::max(view.size().x() + label_room(picture) + 2 * page_margin, 420.0);
  const SwimmerColours colours(picture);
  double top = picture_top + view.size().y() + 12 + scale_bar_room;

  std::string elements =
      definitions(colours.all(), std::max(0.3, bond_width * radius), std::clamp(radius / 15, 0.1, 0.6));
  elements += svg::text({page_margin, 28}, picture.title, {.size = title_size, .weight = "bold"});
  elements += draw_edges(picture, view, true);
  elements += draw_swimmers(picture, colours, view);
  elements += colours.bar(picture, {2 * page_margin + view.size().x(), picture_top},
                          std::clamp(view.size().y(), 90.0, 240.0));
  elements += draw_edges(picture, view, false) + draw_axis_names(picture, view);
  for (const PictureDistance& distance : picture.distances) elements += draw_distance(distance, view);
  elements += draw_marks(picture, view) + draw_scale_bar(picture, view);
  if (!picture.keys.empty()) elements += draw_keys(picture, top += line_pitch);
  const svg::NoteBlock notes =
      svg::draw_notes(picture.notes, {page_margin, top + line_pitch}, width - 2 * page_margin);
  return {.svg = svg::document(width, notes.bottom + page_margin, picture.title, elements + notes.elements),
          .csv = beads_to_csv(picture)};
}

}  // namespace beadswim
