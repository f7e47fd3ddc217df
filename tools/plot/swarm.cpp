#include <fmt/core.h>

#include <algorithm>
#include <memory>

#include "beadswim/core/error.hpp"
#include "beadswim/documents/trajectory_file.hpp"
#include "beadswim/scene/layers.hpp"
#include "beadswim/scene/swimmer_parameters.hpp"
#include "beadswim/scene/units.hpp"
#include "flags.hpp"
#include "kinds.hpp"
#include "swarm_scene.hpp"

namespace beadswim {

enum class SwarmColours {
  blocks,    ///< of neighbouring swimmers, in turn
  swimmers,  ///< each its own, in turn
  types,     ///< of the layout
};

template <>
inline constexpr auto name_table<SwarmColours> = std::to_array<NamedValue<SwarmColours>>(
    {{SwarmColours::blocks, "blocks"}, {SwarmColours::swimmers, "swimmers"}, {SwarmColours::types, "types"}});

namespace {

struct SwarmFlags {
  std::optional<std::size_t> frame{};  ///< from 0; none: the last
  SwarmColours colours = SwarmColours::blocks;
  std::vector<int> block_swimmers{1, 3, 3};  ///< along each axis; or one number: by id, so many to a block
  std::array<int, 3> repeat{1, 1, 1};        ///< periodic copies along each axis
  std::vector<SwimmerMark> marks{};
  bool distances = false;  ///< between neighbours; of layouts alone
};

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

int colour_of(const Cell& cell, std::size_t swimmer, const Three& copy, const Layer& layer,
              const SwarmFlags& options) {
  const auto& types = cell.scene.layout.types;
  switch (options.colours) {
    case SwarmColours::blocks: {
      const int by_id = options.block_swimmers.size() == 1 ? copy[0] + copy[1] + copy[2] : 0;
      return block_number(cell.in_layout(swimmer).id, layer, options.block_swimmers) + by_id;
    }
    case SwarmColours::swimmers:
      return static_cast<int>(swimmer);
    case SwarmColours::types:
      return static_cast<int>(std::distance(types.begin(), types.find(cell.in_layout(swimmer).type)));
  }
  return 0;
}

/// The swarm with its copies.
std::vector<PicturedSwimmer> copies_of(const Cell& cell, const SwarmFlags& options) {
  std::vector<PicturedSwimmer> drawn;
  const auto& [nx, ny, nz] = options.repeat;
  for (int i = 0; i < nx * ny * nz; ++i) {
    const Three copy{i / (ny * nz), i / nz % ny, i % nz};
    const Vec3 shift = Vec3(copy[0], copy[1], copy[2]).cwiseProduct(cell.scene.box);
    for (std::size_t s = 0; s < cell.scene.swimmers.size(); ++s) {
      PicturedSwimmer swimmer = cell.scene.swimmers[s];
      for (Vec3& bead : swimmer.beads) bead += shift;
      swimmer.layer = layer_in_copy(cell, s, copy);
      swimmer.colour = colour_of(cell, s, copy, swimmer.layer, options);
      drawn.push_back(swimmer);
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
    if (found == ids.end()) throw_unknown_swimmer("--mark", mark.id, ids, cell.scene.source);
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

std::vector<PictureDistance> distances(const SwarmScene& scene, const std::vector<PicturedSwimmer>& swimmers,
                                       const std::vector<int>& block_swimmers) {
  if (!scene.laid_out) {
    throw InputError(
        "--distances",
        fmt::format("{} is a trajectory, whose swimmers have moved; give the layout", scene.source));
  }
  if (block_swimmers.size() != 3)
    throw InputError("--distances", "blocks by id have no axes; give --block-swimmers as NX,NY,NZ");
  auto found = swarm_distances(swimmers, block_swimmers);
  if (!found.empty()) return found;
  throw InputError("--distances",
                   "no swimmer has a neighbour along an axis; draw periodic copies too, "
                   "as with --repeat 2,2,2");
}

SwarmPicture swarm_figure(const std::vector<std::string>& files, const SwarmFlags& options) {
  if (files.size() != 1) {
    throw InputError(
        "FILES",
        fmt::format("{} given; a swarm is drawn from one layout, or one trajectory (.h5md)", files.size()));
  }
  const SwarmScene scene = read_swarm_scene(files.front(), options.frame);
  const Three& repeat = options.repeat;
  require_repeatable(scene, repeat);
  const Cell cell = cell_of(scene);
  SwarmPicture picture{.title = "Swarm " + scene.when,
                       .box = scene.box.cwiseProduct(Vec3(repeat[0], repeat[1], repeat[2])),
                       .swimmers = copies_of(cell, options),
                       .keys = keys(scene.layout, options.colours),
                       .marks = marks(cell, options.marks),
                       .notes = {note_on(scene, repeat)}};
  if (options.distances) picture.distances = distances(scene, picture.swimmers, options.block_swimmers);
  std::ranges::copy(type_notes(scene.layout), std::back_inserter(picture.notes));
  return picture;
}

}  // namespace

Drawing add_swarm_flags(CLI::App& command) {
  const auto options = std::make_shared<SwarmFlags>();
  add_frame(command, options->frame);
  add_choice(command, "--colours", options->colours,
             "Colours by blocks of --block-swimmers (as a checkerboard), by swimmers, or by types");
  command
      .add_option_function<std::string>(
          "--block-swimmers",
          [options](const std::string& text) { options->block_swimmers = parse_whole_numbers(text); },
          "Swimmers per block along x, y, z by layers of the layout, or in all by ids")
      ->type_name("NX,NY,NZ|N")
      ->check(number_list({1, 3}, whole_positive()))
      ->default_str("1,3,3");
  command
      .add_option_function<std::string>(
          "--repeat",
          [options](const std::string& text) {
            std::ranges::copy(parse_whole_numbers(text), options->repeat.begin());
          },
          "Periodic copies of the box to draw along x, y, z")
      ->type_name("NX,NY,NZ")
      ->check(number_list({3}, whole_positive()))
      ->default_str("1,1,1");
  add_marks(command, options->marks);
  command.add_flag("--distances", options->distances,
                   "Draw in a layout the distances C between neighbours of a block and D between blocks.");
  return [options](const PlotFiles& files) {
    return swarm_picture_to_svg(swarm_figure(files.inputs, *options));
  };
}

}  // namespace beadswim
