#pragma once

#include <optional>
#include <string>
#include <vector>

#include "beadswim/figure/swarm_picture.hpp"
#include "beadswim/scene/layout.hpp"

namespace beadswim {

/// A swarm at one time: in a frame of a trajectory, or as it was laid out.
struct SwarmScene {
  std::string source;
  std::string when;  ///< "after 124 cycles" or "as laid out"
  bool laid_out = false;
  Layout layout;
  std::vector<std::size_t> in_layout;     ///< index among the layout's swimmers of each of `swimmers`
  std::vector<PicturedSwimmer> swimmers;  ///< each with its middle bead in the box
  Vec3 box = Vec3::Zero();  ///< lengths; in open space of one around the swimmers, which begins at the origin

  bool is_periodic(int axis) const { return layout.domain && layout.domain->is_periodic(axis); }
};

/// Of a layout (JSON, "-" for standard input), or of a trajectory at one frame, none: its last. Throws
/// InputError.
SwarmScene read_swarm_scene(const std::string& path, std::optional<std::size_t> frame);

}  // namespace beadswim
