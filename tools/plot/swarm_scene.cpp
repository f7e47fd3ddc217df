#include "swarm_scene.hpp"

#include <fmt/core.h>

#include "beadswim/core/error.hpp"
#include "beadswim/documents/layout_document.hpp"
#include "beadswim/documents/trajectory_file.hpp"
#include "beadswim/scene/placed_swimmers.hpp"
#include "beadswim/swimmers/swimmer_shape.hpp"
#include "plot_labels.hpp"

namespace beadswim {
namespace {

std::size_t select_frame(const TrajectoryFile& file, std::optional<std::size_t> wanted) {
  const std::size_t last = file.reader.frames() - 1;
  const std::size_t frame = wanted.value_or(last);
  if (frame <= last) return frame;
  throw InputError("--frame", fmt::format("there is no frame {} in {}; give a frame from 0 to {}", frame,
                                          file.source, last));
}

std::vector<std::array<int, 2>> bonds_of(const SwimmerType& type) {
  std::vector<std::array<int, 2>> bonds;
  for (const Bond& bond : type.bonds) bonds.push_back(bond.beads);
  return bonds;
}

SwarmScene scene_of(const TrajectoryFile& file, std::optional<std::size_t> wanted) {
  const TrajectoryHeader& header = file.reader.header();
  const TrajectoryFrame frame = file.reader.frame(select_frame(file, wanted));
  SwarmScene scene{.source = file.source,
                   .time_text = fmt::format("after {}", cycles_text({frame.time / file.period()})),
                   .is_layout = false,
                   .layout = file.layout,
                   .in_layout = file.in_layout,
                   .swimmers = {}};
  const std::vector<std::size_t> first = header.first_beads();
  for (std::size_t s = 0; s < first.size(); ++s) {
    const SwimmerType& type = file.type(s);
    PicturedSwimmer swimmer{.id = header.swimmer[first[s]], .beads = {}, .bonds = bonds_of(type)};
    for (std::size_t b = first[s]; b < first[s] + type.beads.size(); ++b)
      swimmer.beads.push_back({.centre = frame.positions[b], .radius = header.radius[b]});
    scene.swimmers.push_back(std::move(swimmer));
  }
  return scene;
}

SwarmScene scene_of(Layout layout, const std::string& source) {
  SwarmScene scene{.source = source,
                   .time_text = "as laid out",
                   .is_layout = true,
                   .layout = std::move(layout),
                   .in_layout = {},
                   .swimmers = {}};
  const Swarm swarm = listed_swimmers(scene.layout);
  const std::vector<Vec3> centres = start_positions(swarm);
  auto centre = centres.begin();
  for (const PlacedSwimmer& swimmer : swarm.swimmers) {
    const SwimmerType& type = swarm.type_of(swimmer);
    scene.in_layout.push_back(scene.in_layout.size());
    PicturedSwimmer pictured{.id = swimmer.id, .beads = {}, .bonds = bonds_of(type)};
    for (const Bead& bead : type.beads)
      pictured.beads.push_back({.centre = *centre++, .radius = bead.radius});
    scene.swimmers.push_back(std::move(pictured));
  }
  return scene;
}

}  // namespace

SwarmScene read_swarm_scene(const std::string& path, std::optional<std::size_t> frame) {
  if (frame && !is_trajectory(path)) {
    throw InputError("--frame", fmt::format("{} is a layout, and layouts have no frames; leave the flag out",
                                            source_name(path)));
  }
  SwarmScene scene = is_trajectory(path) ? scene_of(open_trajectory(path), frame)
                                         : scene_of(read_layout(path).layout, source_name(path));
  if (!scene.layout.domain.box) {
    const Vec3 before = scene.swimmers.front().middle_bead().centre;
    scene.box = enclose_swimmers(scene.swimmers);
    scene.origin = before - scene.swimmers.front().middle_bead().centre;
    return scene;
  }
  scene.box = scene.layout.domain.box->lengths;
  wrap_swimmers(scene.swimmers, *scene.layout.domain.box);
  return scene;
}

}  // namespace beadswim
