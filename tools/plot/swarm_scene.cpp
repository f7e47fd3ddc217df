#include "swarm_scene.hpp"

#include <fmt/core.h>

#include "beadswim/core/error.hpp"
#include "beadswim/documents/layout_document.hpp"
#include "beadswim/documents/trajectory_file.hpp"
#include "beadswim/scene/placed_swimmers.hpp"
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

/// Adds the swimmers of `in_layout`. `centres`, `radii`: of all their beads [length].
void add_swimmers(const std::vector<Vec3>& centres, const std::vector<double>& radii, SwarmScene& scene) {
  const std::vector<Layer> layers = swimmer_layers(scene.layout);
  scene.layers = layer_count(layers);
  std::size_t next = 0;
  for (const std::size_t index : scene.in_layout) {
    const auto& placed = scene.layout.swimmers[index];
    const SwimmerType& type = scene.layout.types.at(placed.type);
    PicturedSwimmer swimmer{.id = placed.id, .beads = {}, .layer = layers[index]};
    for (const Bond& bond : type.bonds) swimmer.bonds.push_back(bond.beads);
    for (const std::size_t end = next + type.beads.size(); next < end; ++next)
      swimmer.beads.push_back({.centre = centres[next], .radius = radii[next]});
    scene.swimmers.push_back(std::move(swimmer));
  }
}

SwarmScene scene_of(const TrajectoryFile& file, std::optional<std::size_t> wanted) {
  const TrajectoryFrame frame = file.reader.frame(select_frame(file, wanted));
  SwarmScene scene{.source = file.source,
                   .time_text = fmt::format("after {}", cycles_text({frame.time / file.period()})),
                   .layout = file.layout,
                   .in_layout = file.in_layout};
  add_swimmers(frame.positions, file.reader.header().radius, scene);
  return scene;
}

SwarmScene scene_of(Layout layout, const std::string& source) {
  SwarmScene scene{
      .source = source, .time_text = "as laid out", .is_layout = true, .layout = std::move(layout)};
  const Swarm swarm = listed_swimmers(scene.layout);
  for (std::size_t s = 0; s < swarm.swimmers.size(); ++s) scene.in_layout.push_back(s);
  add_swimmers(start_positions(swarm), bead_radii(swarm), scene);
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
