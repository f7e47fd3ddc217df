#include <fmt/core.h>

#include <algorithm>
#include <memory>

#include "beadswim/core/error.hpp"
#include "beadswim/documents/trajectory_file.hpp"
#include "beadswim/scene/swarm.hpp"
#include "beadswim/scene/swimmer_parameters.hpp"
#include "beadswim/scene/units.hpp"
#include "beadswim/swimmers/three_bead_swimmer.hpp"
#include "flags.hpp"
#include "kinds.hpp"
#include "plot_labels.hpp"
#include "swarm_scene.hpp"

namespace beadswim {

enum class SwarmColours {
  blocks,    ///< one colour per block of swimmers; adjacent blocks differ
  swimmers,  ///< one colour per swimmer
  types,     ///< one colour per type of the layout
};

template <>
inline constexpr auto name_table<SwarmColours> = std::to_array<NamedValue<SwarmColours>>(
    {{SwarmColours::blocks, "blocks"}, {SwarmColours::swimmers, "swimmers"}, {SwarmColours::types, "types"}});

namespace {

struct SwarmFlags {
  std::optional<std::size_t> frame{};  ///< counted from 0; no value: the last frame
  SwarmColours colours = SwarmColours::blocks;
  /// Number of swimmers in a block along x, y, z; or one number, for blocks of swimmers with consecutive ids.
  std::vector<int> block_swimmers{1, 3, 3};
  std::vector<int> repeat{1, 1, 1};  ///< periodic copies along each axis
  std::vector<SwimmerMark> marks{};
  bool distances = false;  ///< draws distances between neighbours; only for layouts
};

using Triple = std::array<int, 3>;  // numbers along x, y, z

constexpr std::size_t max_elements = 1000000;  // beads and bonds; keeps the SVG file below about 50 MB

void require_repeatable(const SwarmScene& scene, const Triple& repeat) {
  for (int a = 0; a < 3; ++a) {
    if (repeat[a] == 1 || scene.is_periodic(a)) continue;
    throw InputError("--repeat", fmt::format("{} copies along {} are not possible, because the box of {} is "
                                             "not periodic along this axis; give 1 for this axis",
                                             repeat[a], "xyz"[a], scene.source));
  }
  std::size_t in_box = 0;
  for (const PicturedSwimmer& swimmer : scene.swimmers) in_box += swimmer.beads.size() + swimmer.bonds.size();
  const double elements = static_cast<double>(in_box) * repeat[0] * repeat[1] * repeat[2];
  if (elements > static_cast<double>(max_elements)) {
    throw InputError("--repeat", fmt::format("the copies have {:g} beads and bonds, but at most {} can be "
                                             "drawn; give fewer copies",
                                             elements, max_elements));
  }
}

/// The swarm in the file, with its layers of swimmers. The figure shows periodic copies of this swarm.
struct Cell {
  const SwarmScene& scene;
  std::vector<Layer> layers;  ///< per swimmer: indices of its layers in the layout along x, y, z
  Layer count{};              ///< number of layers along x, y, z

  const Swimmer& in_layout(std::size_t swimmer) const {
    return scene.layout.swimmers[scene.in_layout[swimmer]];
  }
};

Cell cell_of(const SwarmScene& scene) {
  const std::vector<Layer> in_layout = swimmer_layers(scene.layout);
  Cell cell{.scene = scene, .layers = {}, .count = layer_count(in_layout)};
  for (const std::size_t index : scene.in_layout) cell.layers.push_back(in_layout[index]);
  return cell;
}

Layer layer_in_copy(const Cell& cell, std::size_t swimmer, const Triple& copy) {
  Layer layer = cell.layers[swimmer];
  for (int a = 0; a < 3; ++a) layer[a] += copy[a] * cell.count[a];
  return layer;
}

int colour_of(const Cell& cell, std::size_t swimmer, const Triple& copy, const Layer& layer,
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

/// Returns the swimmers of the swarm and of all its periodic copies.
std::vector<PicturedSwimmer> copies_of(const Cell& cell, const SwarmFlags& options) {
  std::vector<PicturedSwimmer> drawn;
  const int nx = options.repeat[0], ny = options.repeat[1], nz = options.repeat[2];
  for (int i = 0; i < nx * ny * nz; ++i) {
    const Triple copy{i / (ny * nz), i / nz % ny, i % nz};
    const Vec3 shift = Vec3(copy[0], copy[1], copy[2]).cwiseProduct(cell.scene.box);
    for (std::size_t s = 0; s < cell.scene.swimmers.size(); ++s) {
      PicturedSwimmer swimmer = cell.scene.swimmers[s];
      for (PicturedBead& bead : swimmer.beads) bead.centre += shift;
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

/// Returns the names to draw, at the middle beads of the swimmers in the first copy of the swarm.
std::vector<PictureMark> marks(const Cell& cell, const std::vector<SwimmerMark>& wanted) {
  std::vector<int> ids;
  for (std::size_t s = 0; s < cell.scene.swimmers.size(); ++s) ids.push_back(cell.in_layout(s).id);
  std::vector<PictureMark> marks;
  for (const SwimmerMark& mark : wanted) {
    const auto found = std::ranges::find(ids, mark.id);
    if (found == ids.end()) throw_unknown_swimmer("--mark", mark.id, ids, cell.scene.source);
    const PicturedBead& bead =
        cell.scene.swimmers[static_cast<std::size_t>(found - ids.begin())].middle_bead();
    marks.push_back({.name = mark.name, .bead = bead.centre, .radius = bead.radius});
  }
  return marks;
}

std::string scene_text(const SwarmScene& scene, const Triple& repeat) {
  const Vec3& box = scene.box;
  const std::size_t swimmers = scene.swimmers.size();
  std::string note = fmt::format("{} swimmer{} in ", swimmers, swimmers == 1 ? "" : "s");
  if (!scene.layout.domain.box) {
    note += in_words(scene.layout.domain) + ", a box drawn around";
  } else {
    note += fmt::format("a box of {:g} × {:g} × {:g}", box.x(), box.y(), box.z());
  }
  if (repeat != Triple{1, 1, 1}) {
    note += fmt::format(", its periodic copies drawn {} × {} × {}", repeat[0], repeat[1], repeat[2]);
  }
  return note + fmt::format(" ({})", unit_names(scene.layout.units));
}

/// Returns a text with the parameters of all swimmer types, as ranges where they differ, and with the number
/// of swimmers that have individual driving.
std::string summarise_types(const Layout& layout) {
  std::vector<double> radii, lengths, stiffnesses, amplitudes, periods;
  for (const auto& [name, type] : layout.types) {
    for (const auto& bead : type.beads) radii.push_back(bead.radius);
    for (const Bond& bond : type.bonds) {
      lengths.push_back(bond.rest_length);
      stiffnesses.push_back(bond.stiffness);
    }
    if (const auto three = three_bead_form(type.driving))
      amplitudes.insert(amplitudes.end(), three->amplitude.begin(), three->amplitude.end());
    periods.push_back(type.driving.period);
  }
  const std::size_t types = layout.types.size();
  std::string text = fmt::format("{} type{}: λ = {}", types, types == 1 ? "" : "s", range_text(radii, 4));
  if (!lengths.empty())
    text += fmt::format(", l = {}, k = {}", range_text(lengths, 4), range_text(stiffnesses, 4));
  if (!amplitudes.empty()) text += ", A, B = " + range_text(amplitudes, 4);
  text += ", T = " + range_text(periods, 6);
  const auto own =
      std::ranges::count_if(layout.swimmers, [](const Swimmer& s) { return s.driving.has_value(); });
  return own == 0 ? text : text + fmt::format("; {} driven otherwise", own);
}

Note types_note(const Layout& layout) {
  const std::string summary = summarise_types(layout);
  return {.text = layout.types.size() == 1 ? type_notes(layout).front() : summary, .summary = summary};
}

/// Returns what the colours mean; an empty note if all swimmers have the same.
Note colours_note(SwarmColours colours, const std::vector<PicturedSwimmer>& swimmers) {
  const auto is_first = [&](const PicturedSwimmer& one) { return one.colour == swimmers.front().colour; };
  if (std::ranges::all_of(swimmers, is_first)) return {};
  switch (colours) {
    case SwarmColours::blocks:
      return {.text = "Blocks of swimmers alternate in colour."};
    case SwarmColours::swimmers:
      return {.text = "Each swimmer has a colour."};
    case SwarmColours::types:
      return {.text = "Colours show the types of the swimmers."};
  }
  return {};
}

std::vector<PictureDistance> distances(const SwarmScene& scene, const std::vector<PicturedSwimmer>& swimmers,
                                       const std::vector<int>& block_swimmers) {
  if (!scene.is_layout) {
    throw InputError("--distances",
                     fmt::format("distances between neighbours are drawn only for a layout, but {} is a "
                                 "trajectory, in which the swimmers have moved; give the layout",
                                 scene.source));
  }
  if (block_swimmers.size() != 3)
    throw InputError("--distances",
                     "distances between neighbours along an axis need the number of swimmers of a block "
                     "along each axis; give --block-swimmers as NX,NY,NZ");
  auto found = swarm_distances(swimmers, block_swimmers);
  if (!found.empty()) return found;
  throw InputError("--distances",
                   "there is no distance to draw, because no swimmer has a neighbour along an axis; draw "
                   "periodic copies too, for example with --repeat 2,2,2");
}

SwarmPicture swarm_figure(const std::vector<std::string>& files, const SwarmFlags& options) {
  const SwarmScene scene = read_swarm_scene(
      only_file(files, "a swarm is drawn from one layout or one trajectory (.h5md)"), options.frame);
  const Triple repeat{options.repeat[0], options.repeat[1], options.repeat[2]};
  require_repeatable(scene, repeat);
  const Cell cell = cell_of(scene);
  SwarmPicture picture{.title = "Swarm " + scene.time_text,
                       .box = scene.box.cwiseProduct(Vec3(repeat[0], repeat[1], repeat[2])),
                       .swimmers = copies_of(cell, options),
                       .keys = keys(scene.layout, options.colours),
                       .marks = marks(cell, options.marks),
                       .length_unit = length_unit(scene.layout.units),
                       .origin = scene.origin};
  picture.notes = {{.text = scene_text(scene, repeat)},
                   colours_note(options.colours, picture.swimmers),
                   types_note(scene.layout)};
  if (options.distances) picture.distances = distances(scene, picture.swimmers, options.block_swimmers);
  return picture;
}

}  // namespace

Drawing add_swarm_flags(CLI::App& command) {
  const auto options = std::make_shared<SwarmFlags>();
  add_frame(command, options->frame);
  add_choice(command, "--colours", options->colours,
             "Property that decides the colour of a swimmer: its block (--block-swimmers; adjacent blocks "
             "differ), its id, or its type");
  add_whole_numbers(command, "--block-swimmers", options->block_swimmers,
                    number_list({1, 3}, whole_positive()),
                    "Number of swimmers in a block: along x, y, z (by layers of the layout), or in total (by "
                    "consecutive ids)")
      ->type_name("NX,NY,NZ|N")
      ->default_str("1,3,3");
  add_whole_numbers(command, "--repeat", options->repeat, number_list({3}, whole_positive()),
                    "Number of periodic copies of the box to draw along x, y, z, the box itself included")
      ->type_name("NX,NY,NZ")
      ->default_str("1,1,1");
  add_marks(command, options->marks);
  command.add_flag("--distances", options->distances,
                   "Draw the distances C between neighbouring swimmers of a block and D between adjacent "
                   "blocks; for layouts only.");
  return [options](const PlotFiles& files) { return swarm_figure(files.inputs, *options); };
}

}  // namespace beadswim
