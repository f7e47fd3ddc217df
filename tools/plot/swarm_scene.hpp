#pragma once

#include <optional>
#include <string>
#include <vector>

#include "beadswim/figure/swarm_picture.hpp"
#include "beadswim/scene/layout.hpp"

namespace beadswim {

/// A swarm at one time: a frame of a trajectory, or a layout.
struct SwarmScene {
  std::string source;
  std::string time_text;  ///< "after 124 cycles" or "as laid out"
  bool is_layout = false;
  Layout layout;
  std::vector<std::size_t> in_layout;  ///< per element of `swimmers`: its index among the layout's swimmers
  std::vector<PicturedSwimmer> swimmers;  ///< the middle bead of each swimmer is in the box
  Vec3 box = Vec3::Zero();  ///< lengths of the box; in open space, of a box around the swimmers [length]

  bool is_periodic(int axis) const { return layout.domain && layout.domain->is_periodic(axis); }
};

/// Reads a layout (JSON, "-" for standard input), or one frame of a trajectory. Without `frame`, reads the
/// last frame. Throws InputError if the file cannot be read, or has no such frame.
SwarmScene read_swarm_scene(const std::string& path, std::optional<std::size_t> frame);

}  // namespace beadswim
