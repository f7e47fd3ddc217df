#pragma once

#include <array>
#include <optional>
#include <vector>

#include "beadswim/core/box.hpp"
#include "beadswim/core/vec3.hpp"
#include "beadswim/lattice/block.hpp"

namespace beadswim {

/// Distances between the interfaces of nested levels.
struct LevelMargins {
  int around_region = 8;  ///< smallest distance of the region from the end of the finest level [finest cell]
  int around_level = 4;   ///< number of cells of each level around the next finer level, at least
};

/// Chooses nested levels around a region. Each level is the smallest box of whole cells of the next coarser
/// level that keeps the margins. Along a periodic axis where it would leave less than `around_level` cells to
/// its own image, it spans the box.
///
/// `cells`: cells of the finest size along each edge of the box; `low`, `high`: corners of the region in
/// these cells. Returns the levels, coarsest first, each in coordinates of its own cells; the first fills the
/// box. Returns nothing if there is no such choice of `count` levels: an edge of the box is not a whole
/// number of coarsest cells, or a level comes too close to a wall.
std::optional<std::vector<Block>> nested_levels(const Index3& cells, const std::array<Boundary, 3>& boundary,
                                                const Vec3& low, const Vec3& high, int count,
                                                const LevelMargins& margins);

}  // namespace beadswim
