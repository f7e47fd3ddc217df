#include "swarm_figure.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "beadswim/core/error.hpp"
#include "trajectory_file.hpp"

namespace beadswim {
namespace {

using Three = std::array<int, 3>;  // along x, y, z

constexpr std::size_t most_swimmers = 200000;  // that a page has room for

/// What the colours go by: of one swimmer of the file.
struct Place {
  int id = 0;
  int type = 0;   ///< index among the layout's
  Three layer{};  ///< in which its middle bead stands in the layout
};

/// Coordinates less than a smallest radius from one another are of one layer. Which layer each is in.
std::vector<int> layers(const std::vector<double>& coordinates, double thickness) {
  std::vector<double> sorted = coordinates;
  std::ranges::sort(sorted);
  std::vector<double> starts{sorted.front()};
  for (std::size_t i = 1; i < sorted.size(); ++i) {
    if (sorted[i] - sorted[i - 1] > thickness) starts.push_back(sorted[i]);
  }
  std::vector<int> result;
  for (const double x : coordinates) {
    result.push_back(static_cast<int>(std::ranges::upper_bound(starts, x) - starts.begin()) - 1);
  }
  return result;
}

/// Of the swimmers in the order of the file.
std::vector<Place> places(const TrajectoryFile& file) {
  const Layout& layout = file.layout;
  std::map<int, const Swimmer*> by_id;
  for (const Swimmer& swimmer : layout.swimmers) by_id[swimmer.id] = &swimmer;
  std::vector<Place> result;
  for (const int id : file.swimmers()) {
    const auto found = by_id.find(id);
    if (found == by_id.end()) {
      throw InputError(
          file.source + ":/particles/beads/swimmer",
          fmt::format("{} is not in the layout; give a trajectory as beadswim-run wrote it", id));
    }
    const auto type = layout.types.find(found->second->type);
    result.push_back({id, static_cast<int>(std::distance(layout.types.begin(), type)), {}});
  }
  for (int a = 0; a < 3; ++a) {
    std::vector<double> coordinates;
    for (const Place& place : result) coordinates.push_back(by_id[place.id]->position[a]);
    const std::vector<int> layer = layers(coordinates, smallest_radius(layout));
    for (std::size_t s = 0; s < result.size(); ++s) result[s].layer[a] = layer[s];
  }
  return result;
}

/// How many layers the box has along each axis.
Three layer_count(const std::vector<Place>& places) {
  Three count{};
  for (const Place& place : places) {
    for (int a = 0; a < 3; ++a) count[a] = std::max(count[a], place.layer[a] + 1);
  }
  return count;
}

int block_colour(const Place& place, const Three& copy, const Three& layer_count,
                 const std::vector<int>& block_swimmers) {
  if (block_swimmers.size() == 1) return place.id / block_swimmers[0] + copy[0] + copy[1] + copy[2];
  int sum = 0;
  for (int a = 0; a < 3; ++a) sum += (copy[a] * layer_count[a] + place.layer[a]) / block_swimmers[a];
  return sum % 2;
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

int colour_of(const Place& place, std::size_t order, const Three& copy, const Three& layers,
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
};

Cell cell_of(const TrajectoryFile& file, const TrajectoryFrame& frame) {
  const TrajectoryHeader& header = file.reader.header();
  Cell cell{header.box_lengths, {}, places(file)};
  for (std::size_t bead = 0; bead < frame.positions.size(); bead += 3) {
    cell.swimmers.push_back(in_the_box(header, frame, bead));
  }
  return cell;
}

void add_copy(const Cell& cell, const Three& copy, const SwarmFigureOptions& options,
              std::vector<PicturedSwimmer>& swimmers) {
  const Vec3 shift = Vec3(copy[0], copy[1], copy[2]).cwiseProduct(cell.box);
  const Three layers = layer_count(cell.places);
  for (std::size_t s = 0; s < cell.swimmers.size(); ++s) {
    PicturedSwimmer swimmer = cell.swimmers[s];
    for (Vec3& bead : swimmer.beads) bead += shift;
    swimmer.colour = colour_of(cell.places[s], s, copy, layers, options);
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
  std::string note = fmt::format("{} swimmer{} in a box of {:g} × {:g} × {:g}", swimmers,
                                 swimmers == 1 ? "" : "s", box.x(), box.y(), box.z());
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
