#pragma once

#include <optional>
#include <string>
#include <vector>

#include "beadswim/figure/swarm_picture.hpp"
#include "beadswim/scene/layout.hpp"
#include "beadswim/scene/swarm.hpp"

namespace beadswim {

/// Swimmers at one time, read from a layout or from a frame of a trajectory.
struct SwarmScene {
  std::string source;
  std::string time_text;  ///< "after 124 cycles" or "as laid out"
  bool is_layout = false;
  Layout layout;
  std::vector<std::size_t> in_layout{};     ///< index in layout.swimmers of each element of `swimmers`
  std::vector<PicturedSwimmer> swimmers{};  ///< with layers; the middle bead of each is in the box
  Layer layers{};                           ///< number of layers of swimmers along x, y, z
  Vec3 box = Vec3::Zero();     ///< edges of the box, or, in open space, of a box around the swimmers [length]
  Vec3 origin = Vec3::Zero();  ///< place of the corner of this box in the coordinates of the layout [length]

  bool is_periodic(int axis) const { return layout.domain.box && layout.domain.box->is_periodic(axis); }
};

/// Reads a layout (JSON, "-" for standard input), or one frame of a trajectory. `frame`: number of the frame;
/// nullopt: the last frame. Throws InputError if the file cannot be read, or if it has no such frame.
SwarmScene read_swarm_scene(const std::string& path, std::optional<std::size_t> frame);

}  // namespace beadswim
