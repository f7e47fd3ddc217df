#include "swarm_figure.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "beadswim/core/error.hpp"
#include "beadswim/documents/trajectory_file.hpp"
#include "beadswim/scene/layers.hpp"
#include "swarm_distances.hpp"
#include "swarm_scene.hpp"
#include "swimmer_parameters.hpp"

namespace beadswim {
namespace {

using Three = std::array<int, 3>;  // along x, y, z

constexpr std::size_t most_swimmers = 200000;  // that a page has room for

void require_repeatable(const SwarmScene& scene, const Three& repeat) {
  for (int a = 0; a < 3; ++a) {
    if (repeat[a] == 1 || scene.is_periodic(a)) continue;
    throw InputError("--repeat", fmt::format("{} along {}, where the box of {} is not periodic; give 1 there",
                                             repeat[a], "xyz"[a], scene.source));
  }
  const double swimmers = static_cast<double>(scene.swimmers.size()) * repeat[0] * repeat[1] * repeat[2];
  if (swimmers > static_cast<double>(most_swimmers)) {
    throw InputError("--repeat", fmt::format("makes {:g} swimmers, and at most {} can be drawn; give fewer "
                                             "copies",
                                             swimmers, most_swimmers));
  }
}

/// One cell of the swarm.
struct Cell {
  const SwarmScene& scene;
  std::vector<Layer> layers;  ///< in which the swimmers' middle beads stand in the layout
  Layer count{};              ///< how many layers there are

  const Swimmer& in_layout(std::size_t swimmer) const {
    return scene.layout.swimmers[scene.in_layout[swimmer]];
  }
};

Cell cell_of(const SwarmScene& scene) {
  const std::vector<Layer> in_layout = swimmer_layers(scene.layout);
  Cell cell{scene, {}, layer_count(in_layout)};
  for (const std::size_t index : scene.in_layout) cell.layers.push_back(in_layout[index]);
  return cell;
}

Layer layer_in_copy(const Cell& cell, std::size_t swimmer, const Three& copy) {
  Layer layer = cell.layers[swimmer];
  for (int a = 0; a < 3; ++a) layer[a] += copy[a] * cell.count[a];
  return layer;
}

int colour_of(const Cell& cell, std::size_t swimmer, const Three& copy, const SwarmFigureOptions& options) {
  const auto& types = cell.scene.layout.types;
  switch (options.colours) {
    case SwarmColours::blocks: {
      const int by_id = options.block_swimmers.size() == 1 ? copy[0] + copy[1] + copy[2] : 0;
      return block_number(cell.in_layout(swimmer).id, layer_in_copy(cell, swimmer, copy),
                          options.block_swimmers) +
             by_id;
    }
    case SwarmColours::swimmers:
      return static_cast<int>(swimmer);
    case SwarmColours::types:
      return static_cast<int>(std::distance(types.begin(), types.find(cell.in_layout(swimmer).type)));
  }
  return 0;
}

/// The swarm with its copies, and the layers of its swimmers.
struct Drawn {
  std::vector<PicturedSwimmer> swimmers;
  std::vector<Layer> layers;
};

Drawn copies_of(const Cell& cell, const SwarmFigureOptions& options) {
  Drawn drawn;
  const auto& [nx, ny, nz] = options.repeat;
  for (int i = 0; i < nx * ny * nz; ++i) {
    const Three copy{i / (ny * nz), i / nz % ny, i % nz};
    const Vec3 shift = Vec3(copy[0], copy[1], copy[2]).cwiseProduct(cell.scene.box);
    for (std::size_t s = 0; s < cell.scene.swimmers.size(); ++s) {
      PicturedSwimmer swimmer = cell.scene.swimmers[s];
      for (Vec3& bead : swimmer.beads) bead += shift;
      swimmer.colour = colour_of(cell, s, copy, options);
      drawn.swimmers.push_back(swimmer);
      drawn.layers.push_back(layer_in_copy(cell, s, copy));
    }
  }
  return drawn;
}

std::vector<PictureKey> keys(const Layout& layout, SwarmColours colours) {
  std::vector<PictureKey> keys;
  if (colours != SwarmColours::types) return keys;
  for (const auto& [name, type] : layout.types) keys.push_back({name, static_cast<int>(keys.size())});
  return keys;
}

/// At the middle beads, in the swarm itself rather than its copies.
std::vector<PictureMark> marks(const Cell& cell, const std::vector<SwimmerMark>& wanted) {
  std::vector<int> ids;
  for (std::size_t s = 0; s < cell.scene.swimmers.size(); ++s) ids.push_back(cell.in_layout(s).id);
  std::vector<PictureMark> marks;
  for (const SwimmerMark& mark : wanted) {
    const auto found = std::ranges::find(ids, mark.id);
    if (found == ids.end()) refuse_swimmer("--mark", mark.id, ids, cell.scene.source);
    const PicturedSwimmer& swimmer = cell.scene.swimmers[static_cast<std::size_t>(found - ids.begin())];
    marks.push_back({mark.name, swimmer.beads[1], swimmer.radii[1]});
  }
  return marks;
}

std::string note_on(const SwarmScene& scene, const Three& repeat) {
  const Vec3& box = scene.box;
  const std::size_t swimmers = scene.swimmers.size();
  std::string note = fmt::format("{} swimmer{} in ", swimmers, swimmers == 1 ? "" : "s");
  if (!scene.layout.domain) {
    note += "open space, a box drawn around";
  } else {
    note += fmt::format("a box of {:g} × {:g} × {:g}", box.x(), box.y(), box.z());
  }
  if (repeat != Three{1, 1, 1}) {
    note += fmt::format(", its periodic copies drawn {} × {} × {}", repeat[0], repeat[1], repeat[2]);
  }
  return note + fmt::format(" ({})", unit_names(scene.layout.units));
}

void require_laid_out(const SwarmScene& scene) {
  if (scene.laid_out) return;
  throw InputError(
      "--distances",
      fmt::format("{} is a trajectory, whose swimmers have moved; give the layout", scene.source));
}

}  // namespace

SwarmPicture swarm_figure(const std::vector<std::string>& files, const SwarmFigureOptions& options) {
  if (files.size() != 1) {
    throw InputError(
        "FILES",
        fmt::format("{} given; a swarm is drawn from one layout, or one trajectory (.h5md)", files.size()));
  }
  const SwarmScene scene = read_swarm_scene(files.front(), options.frame);
  const Three& repeat = options.repeat;
  require_repeatable(scene, repeat);
  const Cell cell = cell_of(scene);
  Drawn drawn = copies_of(cell, options);
  SwarmPicture picture{.title = "Swarm " + scene.when,
                       .box = scene.box.cwiseProduct(Vec3(repeat[0], repeat[1], repeat[2])),
                       .keys = keys(scene.layout, options.colours),
                       .marks = marks(cell, options.marks),
                       .notes = {note_on(scene, repeat)}};
  if (options.distances) {
    require_laid_out(scene);
    picture.distances = swarm_distances(drawn.swimmers, drawn.layers, options.block_swimmers);
  }
  picture.swimmers = std::move(drawn.swimmers);
  std::ranges::copy(type_notes(scene.layout), std::back_inserter(picture.notes));
  return picture;
}

}  // namespace beadswim
