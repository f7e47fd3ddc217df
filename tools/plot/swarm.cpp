#include <fmt/core.h>

#include <algorithm>
#include <memory>

#include "beadswim/core/error.hpp"
#include "beadswim/documents/layout_document.hpp"
#include "beadswim/documents/trajectory_file.hpp"
#include "beadswim/figure/swarm_picture.hpp"
#include "beadswim/scene/placed_swimmers.hpp"
#include "beadswim/scene/swarm.hpp"
#include "beadswim/scene/swimmer_parameters.hpp"
#include "beadswim/scene/units.hpp"
#include "beadswim/swimmers/swimmer_shape.hpp"
#include "beadswim/swimmers/three_bead_swimmer.hpp"
#include "kinds.hpp"
#include "plot_labels.hpp"
#include "swarm_values.hpp"

// Pictures of a swarm, which is read from a layout or from one frame of a trajectory.

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
  std::optional<ResultQuantity> colour{};  ///< result that colours show; nullopt: `colours`
  /// Number of swimmers in a block along x, y, z; or one number, for blocks of swimmers with consecutive ids.
  std::vector<int> block_swimmers{1, 3, 3};
  std::vector<int> repeat{1, 1, 1};  ///< periodic copies along each axis
  std::vector<std::pair<std::string, int>> marks{};  ///< names to write beside swimmers, with their ids
  bool distances = false;  ///< draws distances between neighbours; only for layouts
};

/// Swimmers at one time, read from a layout or from a frame of a trajectory.
struct SwarmScene {
  std::string source;
  bool is_layout = false;
  Layout layout{};
  std::vector<std::size_t> in_layout{};  ///< index in layout.swimmers of each swimmer of the picture
  double time = 0;                       ///< of the frame
  Layer layers{};                        ///< number of layers of swimmers along x, y, z
  SwarmPicture picture{};  ///< without copies; the box of swimmers in open space is drawn around them
};

/// Adds the swimmers of `in_layout`. `centres`, `radii`: of all their beads [length].
void add_swimmers(const std::vector<Vec3>& centres, const std::vector<double>& radii, SwarmScene& scene) {
  const std::vector<Layer> layers = swimmer_layers(scene.layout);
  scene.layers = layer_count(layers);
  std::size_t next = 0;
  for (const std::size_t index : scene.in_layout) {
    const Swimmer& placed = scene.layout.swimmers[index];
    const SwimmerType& type = scene.layout.types.at(placed.type);
    PicturedSwimmer swimmer{.id = placed.id, .beads = {}, .layer = layers[index]};
    for (const Bond& bond : type.bonds) swimmer.bonds.push_back(bond.beads);
    swimmer.axis = axis_of(type, std::span(centres).subspan(next, type.beads.size()), placed.orientation());
    for (const std::size_t end = next + type.beads.size(); next < end; ++next)
      swimmer.beads.push_back({.centre = centres[next], .radius = radii[next]});
    scene.picture.swimmers.push_back(std::move(swimmer));
  }
}

/// Reads one frame of a trajectory. `wanted`: number of the frame; nullopt: the last frame.
void read_frame(const std::string& path, std::optional<std::size_t> wanted, SwarmScene& scene) {
  const TrajectoryFile file = open_trajectory(path);
  const std::size_t last = file.reader.frames() - 1, number = wanted.value_or(last);
  if (number > last)
    throw InputError("--frame", "there is no frame {} in {}; give a frame from 0 to {}", number, file.source,
                     last);
  const TrajectoryFrame frame = file.reader.frame(number);
  scene.picture.title = fmt::format("Swarm after {}", cycles_text({frame.time / file.period()}));
  scene.time = frame.time;
  scene.layout = file.layout;
  scene.in_layout = file.in_layout;
  add_swimmers(frame.positions, file.reader.header().radius, scene);
}

/// Reads a layout (JSON, "-" for standard input), or one frame of a trajectory. `frame`: number of the frame;
/// nullopt: the last frame. The middle bead of each swimmer is then in the box. Throws InputError if the file
/// cannot be read, or if it has no such frame.
SwarmScene read_swarm_scene(const std::string& path, std::optional<std::size_t> frame) {
  SwarmScene scene{.source = source_name(path), .is_layout = !is_trajectory(path)};
  if (frame && scene.is_layout)
    throw InputError("--frame", "{} is a layout, and layouts have no frames; leave the flag out",
                     scene.source);
  SwarmPicture& picture = scene.picture;
  if (scene.is_layout) {
    picture.title = "Swarm as laid out";
    scene.layout = read_layout(path).layout;
    const Swarm swarm = listed_swimmers(scene.layout);
    for (std::size_t s = 0; s < swarm.swimmers.size(); ++s) scene.in_layout.push_back(s);
    add_swimmers(start_positions(swarm), bead_radii(swarm), scene);
  } else {
    read_frame(path, frame, scene);
  }
  picture.length_unit = length_unit(scene.layout.units);
  if (const auto& box = scene.layout.domain.box) {
    picture.box = box->lengths;
    wrap_swimmers(picture.swimmers, *box);
  } else {
    const Vec3 before = picture.swimmers.front().middle_bead().centre;
    picture.box = enclose_swimmers(picture.swimmers);
    picture.origin = before - picture.swimmers.front().middle_bead().centre;
  }
  return scene;
}

using Triple = std::array<int, 3>;  // numbers along x, y, z

constexpr std::size_t max_elements = 1000000;  // beads and bonds; keeps the SVG file below about 50 MB

void require_repeatable(const SwarmScene& scene, const Triple& repeat) {
  const auto& box = scene.layout.domain.box;
  for (int a = 0; a < 3; ++a) {
    if (repeat[a] == 1 || (box && box->is_periodic(a))) continue;
    throw InputError("--repeat",
                     "{} copies along {} are not possible, because the box of {} is not periodic along this "
                     "axis; give 1 for this axis",
                     repeat[a], "xyz"[a], scene.source);
  }
  std::size_t in_box = 0;
  for (const PicturedSwimmer& swimmer : scene.picture.swimmers)
    in_box += swimmer.beads.size() + swimmer.bonds.size();
  const double elements = static_cast<double>(in_box) * repeat[0] * repeat[1] * repeat[2];
  if (elements > static_cast<double>(max_elements)) {
    throw InputError("--repeat",
                     "the copies have {:g} beads and bonds, but at most {} can be drawn; give fewer copies",
                     elements, max_elements);
  }
}

/// Returns the colour of a swimmer in a periodic copy, whose layer there is `swimmer.layer`.
int colour_of(const SwarmScene& scene, const PicturedSwimmer& swimmer, std::size_t index, const Triple& copy,
              const SwarmFlags& options) {
  const auto& [types, swimmers] = std::tie(scene.layout.types, scene.layout.swimmers);
  switch (options.colours) {
    case SwarmColours::blocks: {
      const int by_id = options.block_swimmers.size() == 1 ? copy[0] + copy[1] + copy[2] : 0;
      return block_number(swimmer.id, swimmer.layer, options.block_swimmers) + by_id;
    }
    case SwarmColours::swimmers:
      return static_cast<int>(index);
    case SwarmColours::types:
      return static_cast<int>(
          std::distance(types.begin(), types.find(swimmers[scene.in_layout[index]].type)));
  }
  return 0;
}

constexpr std::size_t max_heads = 4000;  // of more swimmers they would be too small to see

/// Returns the swimmers of the swarm and of all its periodic copies; those of a large swarm have no heads.
std::vector<PicturedSwimmer> copies_of(const SwarmScene& scene, const SwarmFlags& options) {
  std::vector<PicturedSwimmer> drawn;
  const int nx = options.repeat[0], ny = options.repeat[1], nz = options.repeat[2];
  const bool has_heads = scene.picture.swimmers.size() * nx * ny * nz <= max_heads;
  for (int i = 0; i < nx * ny * nz; ++i) {
    const Triple copy{i / (ny * nz), i / nz % ny, i % nz};
    const Vec3 shift = Vec3(copy[0], copy[1], copy[2]).cwiseProduct(scene.picture.box);
    for (std::size_t s = 0; s < scene.picture.swimmers.size(); ++s) {
      PicturedSwimmer swimmer = scene.picture.swimmers[s];
      for (PicturedBead& bead : swimmer.beads) bead.centre += shift;
      for (int a = 0; a < 3; ++a) swimmer.layer[a] += copy[a] * scene.layers[a];
      swimmer.colour = colour_of(scene, swimmer, s, copy, options);
      if (!has_heads) swimmer.axis.setZero();
      drawn.push_back(swimmer);
    }
  }
  return drawn;
}

/// Returns the names to draw, at the middle beads of the swimmers in the first copy of the swarm.
std::vector<PictureMark> marks(const SwarmScene& scene, const SwarmFlags& options) {
  std::vector<int> ids;
  for (const PicturedSwimmer& swimmer : scene.picture.swimmers) ids.push_back(swimmer.id);
  std::vector<PictureMark> marks;
  for (const auto& [name, id] : options.marks) {
    const std::size_t index = swimmer_with_id(id, ids, "--mark", scene.source);
    marks.push_back({name, scene.picture.swimmers[index].middle_bead()});
  }
  return marks;
}

std::string scene_text(const SwarmScene& scene, const Triple& repeat) {
  const Vec3& box = scene.picture.box;
  const std::size_t swimmers = scene.picture.swimmers.size();
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
  constexpr std::array meanings{"Blocks of swimmers alternate in colour.", "Each swimmer has a colour.",
                                "Colours show the types of the swimmers."};
  const auto is_first = [&](const PicturedSwimmer& one) { return one.colour == swimmers.front().colour; };
  if (std::ranges::all_of(swimmers, is_first)) return {};
  return {.text = meanings[static_cast<std::size_t>(colours)]};
}

std::vector<PictureDistance> distances(const SwarmScene& scene, const std::vector<PicturedSwimmer>& swimmers,
                                       const std::vector<int>& block_swimmers) {
  if (!scene.is_layout) {
    throw InputError("--distances",
                     "distances between neighbours are drawn only for a layout, but {} is a trajectory, in "
                     "which the swimmers have moved; give the layout",
                     scene.source);
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

/// Sets the values that colours show. `record`: file with the results; empty: the trajectory has them.
void add_values(ResultQuantity quantity, const std::string& record, SwarmScene& scene) {
  if (scene.is_layout)
    throw InputError("--colour", "{} is a layout, which has no results; give the trajectory of a run",
                     scene.source);
  std::vector<int> ids;
  for (const PicturedSwimmer& swimmer : scene.picture.swimmers) ids.push_back(swimmer.id);
  const auto values = last_values(quantity, scene.source, record, scene.time, ids);
  for (std::size_t s = 0; s < ids.size(); ++s) scene.picture.swimmers[s].value = values[s];
  scene.picture.value_label = result_label(quantity, scene.layout.units);
}

SwarmPicture swarm_figure(const std::vector<std::string>& files, const SwarmFlags& options) {
  const bool has_record = options.colour && files.size() == 2;
  SwarmScene scene = read_swarm_scene(
      has_record ? files.front()
                 : only_file(files, "a swarm is drawn from one layout or one trajectory (.h5md)"),
      options.frame);
  if (options.colour) add_values(*options.colour, has_record ? files.back() : "", scene);
  const Triple repeat{options.repeat[0], options.repeat[1], options.repeat[2]};
  require_repeatable(scene, repeat);
  SwarmPicture picture = scene.picture;
  picture.box = picture.box.cwiseProduct(Vec3(repeat[0], repeat[1], repeat[2]));
  picture.swimmers = copies_of(scene, options);
  picture.marks = marks(scene, options);
  if (options.colours == SwarmColours::types)
    for (const auto& [name, type] : scene.layout.types) picture.keys.push_back(name);
  picture.notes = {{.text = scene_text(scene, repeat)},
                   {.text = picture.swimmers.size() <= max_heads ? "Triangles are heads." : ""},
                   options.colour ? Note{.text = "Colours: last cycle of each swimmer before this frame."}
                                  : colours_note(options.colours, picture.swimmers),
                   types_note(scene.layout)};
  if (options.distances) picture.distances = distances(scene, picture.swimmers, options.block_swimmers);
  return picture;
}

/// Parses the value of --frame, "last" (nullopt) or a whole number. Throws InputError for another text.
std::optional<std::size_t> parse_frame(const std::string& text) {
  if (text == "last") return std::nullopt;
  if (id_or_frame_number()(text).empty()) return std::stoul(text);
  throw InputError("--frame", "\"{}\": the frame must be \"last\" or a whole number, 0 or greater", text);
}

/// Parses a mark NAME=ID, such as "A=3". Throws InputError if the text has another form.
std::pair<std::string, int> parse_mark(const std::string& text) {
  const std::size_t sign = text.rfind('=');
  const std::string id = sign == std::string::npos ? "" : text.substr(sign + 1);
  if (sign == 0 || !id_or_frame_number()(id).empty())
    throw InputError("--mark", "\"{}\": the value must be a label and a swimmer's id, such as A=3", text);
  return {text.substr(0, sign), std::stoi(id)};
}

}  // namespace

DrawFigure add_swarm_flags(CLI::App& command) {
  const auto options = std::make_shared<SwarmFlags>();
  const auto take_frame = [options](const std::string& text) { options->frame = parse_frame(text); };
  add_value(command, "--frame", take_frame, {.name = "last|N", .initial = "last"},
            "Number of the trajectory frame to draw, counted from 0");
  CLI::Option* colours = add_choice(
      command, "--colours", options->colours,
      "Property that decides the colour of a swimmer: its block (--block-swimmers; adjacent blocks "
      "differ), its id, or its type");
  add_choice(command, "--colour", options->colour,
             "Result that colours show, of beadswim-plot against, in each swimmer's last cycle before the "
             "frame; a record as second file adds results")
      ->type_name("NAME")
      ->excludes(colours);
  add_list(command, "--block-swimmers", options->block_swimmers,
           {"NX,NY,NZ|N", number_list({1, 3}, whole_positive()), "1,3,3"},
           "Number of swimmers in a block: along x, y, z (by layers of the layout), or in total (by "
           "consecutive ids)");
  add_list(command, "--repeat", options->repeat, {"NX,NY,NZ", number_list({3}, whole_positive()), "1,1,1"},
           "Number of periodic copies of the box to draw along x, y, z, the box itself included");
  command
      .add_option_function<std::vector<std::string>>(
          "--mark",
          [options](const std::vector<std::string>& texts) {
            for (const std::string& text : texts) options->marks.push_back(parse_mark(text));
          },
          "Names to write beside swimmers, each with the id of its swimmer, for example A=3.")
      ->type_name("NAME=ID,...")
      ->delimiter(',')
      ->default_str("none");
  command.add_flag("--distances", options->distances,
                   "Draw the distances C between neighbouring swimmers of a block and D between adjacent "
                   "blocks; for layouts only.");
  return [options](const PlotFiles& files) { return draw(swarm_figure(files.inputs, *options)); };
}

}  // namespace beadswim
