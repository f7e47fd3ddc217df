#include "swarm_figure.hpp"

#include <fmt/core.h>

#include <cmath>

#include "beadswim/core/error.hpp"
#include "beadswim/documents/trajectory_file.hpp"
#include "beadswim/layout/layers.hpp"

namespace beadswim {
namespace {

using Three = std::array<int, 3>;  // along x, y, z

constexpr std::size_t most_swimmers = 200000;  // that a page has room for

/// What the colours go by: of one swimmer of the file.
struct Place {
  int id = 0;
  int type = 0;   ///< index among the layout's
  Layer layer{};  ///< in which its middle bead stands in the layout
};

/// Of the swimmers in the order of the file.
std::vector<Place> places(const TrajectoryFile& file) {
  const Layout& layout = file.layout;
  const std::vector<Layer> layers = swimmer_layers(layout);
  std::vector<Place> result;
  for (const std::size_t index : file.in_layout) {
    const Swimmer& swimmer = layout.swimmers[index];
    const auto type = layout.types.find(swimmer.type);
    result.push_back(
        {swimmer.id, static_cast<int>(std::distance(layout.types.begin(), type)), layers[index]});
  }
  return result;
}

/// In a periodic copy of the box, of which it has so many layers.
int block_colour(const Place& place, const Three& copy, const Layer& layers,
                 const std::vector<int>& block_swimmers) {
  Layer layer = place.layer;
  for (int a = 0; a < 3; ++a) layer[a] += copy[a] * layers[a];
  const int by_id = block_swimmers.size() == 1 ? copy[0] + copy[1] + copy[2] : 0;
  return block_number(place.id, layer, block_swimmers) + by_id;
}

std::size_t chosen_frame(const TrajectoryFile& file, const SwarmFigureOptions& options) {
  const std::size_t last = file.reader.frames() - 1;
  const std::size_t frame = options.frame.value_or(last);
  if (frame <= last) return frame;
  throw InputError("--frame", fmt::format("no frame {} in {}; the last is {}", frame, file.source, last));
}

void require_repeatable(const TrajectoryFile& file, const Three& repeat) {
  for (int a = 0; a < 3; ++a) {
    if (repeat[a] == 1 || file.reader.header().periodic[a]) continue;
    throw InputError("--repeat", fmt::format("{} along {}, where the box of {} is not periodic; give 1 there",
                                             repeat[a], "xyz"[a], file.source));
  }
  const double swimmers = static_cast<double>(file.swimmers().size()) * repeat[0] * repeat[1] * repeat[2];
  if (swimmers > static_cast<double>(most_swimmers)) {
    throw InputError("--repeat", fmt::format("makes {:g} swimmers, and at most {} can be drawn; give fewer "
                                             "copies",
                                             swimmers, most_swimmers));
  }
}

/// The swimmer of beads from `first` on, moved by whole boxes so that its middle bead is in the box.
PicturedSwimmer in_the_box(const TrajectoryHeader& header, const TrajectoryFrame& frame, std::size_t first) {
  Vec3 shift = Vec3::Zero();
  for (int a = 0; a < 3; ++a) {
    const double length = header.box_lengths[a];
    if (header.periodic[a]) shift[a] = -length * std::floor(frame.positions[first + 1][a] / length);
  }
  PicturedSwimmer swimmer;
  for (std::size_t b = 0; b < 3; ++b) {
    swimmer.beads[b] = frame.positions[first + b] + shift;
    swimmer.radii[b] = header.radius[first + b];
  }
  return swimmer;
}

int colour_of(const Place& place, std::size_t order, const Three& copy, const Layer& layers,
              const SwarmFigureOptions& options) {
  switch (options.colours) {
    case SwarmColours::blocks:
      return block_colour(place, copy, layers, options.block_swimmers);
    case SwarmColours::swimmers:
      return static_cast<int>(order);
    case SwarmColours::types:
      return place.type;
  }
  return 0;
}

/// One cell of the swarm.
struct Cell {
  Vec3 box;
  std::vector<PicturedSwimmer> swimmers;
  std::vector<Place> places;  ///< of the swimmers
  Layer layers{};             ///< how many it has
};

/// In open space: a box around the swimmers, which begins at the origin.
void put_in_box(Cell& cell) {
  Vec3 low = Vec3::Constant(INFINITY), high = -low;
  for (const PicturedSwimmer& swimmer : cell.swimmers) {
    for (std::size_t b = 0; b < 3; ++b) {
      low = low.cwiseMin((swimmer.beads[b].array() - 2 * swimmer.radii[b]).matrix());
      high = high.cwiseMax((swimmer.beads[b].array() + 2 * swimmer.radii[b]).matrix());
    }
  }
  cell.box = high - low;
  for (PicturedSwimmer& swimmer : cell.swimmers) {
    for (Vec3& bead : swimmer.beads) bead -= low;
  }
}

Cell cell_of(const TrajectoryFile& file, const TrajectoryFrame& frame) {
  const TrajectoryHeader& header = file.reader.header();
  Cell cell{header.box_lengths, {}, places(file), layer_count(swimmer_layers(file.layout))};
  for (std::size_t bead = 0; bead < frame.positions.size(); bead += 3) {
    cell.swimmers.push_back(in_the_box(header, frame, bead));
  }
  if (!file.layout.domain) put_in_box(cell);
  return cell;
}

void add_copy(const Cell& cell, const Three& copy, const SwarmFigureOptions& options,
              std::vector<PicturedSwimmer>& swimmers) {
  const Vec3 shift = Vec3(copy[0], copy[1], copy[2]).cwiseProduct(cell.box);
  for (std::size_t s = 0; s < cell.swimmers.size(); ++s) {
    PicturedSwimmer swimmer = cell.swimmers[s];
    for (Vec3& bead : swimmer.beads) bead += shift;
    swimmer.colour = colour_of(cell.places[s], s, copy, cell.layers, options);
    swimmers.push_back(swimmer);
  }
}

std::vector<PictureKey> keys(const TrajectoryFile& file, SwarmColours colours) {
  std::vector<PictureKey> keys;
  if (colours != SwarmColours::types) return keys;
  for (const auto& [name, type] : file.layout.types) keys.push_back({name, static_cast<int>(keys.size())});
  return keys;
}

std::string note_on(const TrajectoryFile& file, const Three& repeat) {
  const Vec3& box = file.reader.header().box_lengths;
  const std::size_t swimmers = file.swimmers().size();
  std::string note = fmt::format("{} swimmer{} in ", swimmers, swimmers == 1 ? "" : "s");
  if (!file.layout.domain) return note + "open space, a box drawn around";
  note += fmt::format("a box of {:g} × {:g} × {:g}", box.x(), box.y(), box.z());
  if (repeat != Three{1, 1, 1}) {
    note += fmt::format(", its periodic copies drawn {} × {} × {}", repeat[0], repeat[1], repeat[2]);
  }
  return note;
}

}  // namespace

SwarmPicture swarm_figure(const std::vector<std::string>& files, const SwarmFigureOptions& options) {
  if (files.size() != 1) {
    throw InputError("FILES",
                     fmt::format("{} given; a swarm is drawn from one trajectory (.h5md)", files.size()));
  }
  const TrajectoryFile file = open_trajectory(files.front());
  require_repeatable(file, options.repeat);
  const TrajectoryFrame frame = file.reader.frame(chosen_frame(file, options));
  const Cell cell = cell_of(file, frame);
  const Three& repeat = options.repeat;
  SwarmPicture picture{.title = fmt::format("Swarm after {:.4g} cycles", frame.time / file.period()),
                       .box = cell.box.cwiseProduct(Vec3(repeat[0], repeat[1], repeat[2])),
                       .keys = keys(file, options.colours),
                       .notes = {note_on(file, repeat)}};
  for (int x = 0; x < repeat[0]; ++x) {
    for (int y = 0; y < repeat[1]; ++y) {
      for (int z = 0; z < repeat[2]; ++z) add_copy(cell, {x, y, z}, options, picture.swimmers);
    }
  }
  return picture;
}

}  // namespace beadswim
