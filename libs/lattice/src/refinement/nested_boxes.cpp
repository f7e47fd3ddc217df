#include "beadswim/lattice/nested_boxes.hpp"

#include <cmath>

namespace beadswim {
namespace {

int floor_to_even(double x) {
  return 2 * static_cast<int>(std::floor(x / 2));
}
int ceil_to_even(double x) {
  return 2 * static_cast<int>(std::ceil(x / 2));
}

/// Places a level along one axis so that it contains [low, high], with `room` cells to its own image. Returns
/// false if a wall is in the way.
bool place_along(int axis, const Index3& cells, const std::array<Boundary, 3>& boundary, double low,
                 double high, int room, Block& level) {
  level.offset[axis] = floor_to_even(low);
  level.size[axis] = ceil_to_even(high) - level.offset[axis];
  if (boundary[axis] == Boundary::periodic) {
    if (level.size[axis] + 2 * room <= cells[axis]) return true;
    level.offset[axis] = 0;
    level.size[axis] = cells[axis];
    return true;
  }
  return level.offset[axis] >= 2 * room && level.offset[axis] + level.size[axis] + 2 * room <= cells[axis];
}

}  // namespace

std::optional<std::vector<Block>> nested_levels(const Index3& cells, const std::array<Boundary, 3>& boundary,
                                                const Vec3& low, const Vec3& high, int count,
                                                const LevelMargins& margins) {
  std::vector<Block> levels(count);
  Index3 box = cells;
  Vec3 first = low.array() - margins.around_region, end = high.array() + margins.around_region;
  for (int n = count - 1; n > 0; --n) {
    if ((box / 2 * 2 != box).any()) return std::nullopt;
    for (int a = 0; a < 3; ++a)
      if (!place_along(a, box, boundary, first[a], end[a], margins.around_level, levels[n]))
        return std::nullopt;
    first = levels[n].offset.cast<double>() / 2 - margins.around_level;
    end = levels[n].end().cast<double>() / 2 + margins.around_level;
    box /= 2;
  }
  levels[0] = {.offset = Index3::Zero(), .size = box};
  return levels;
}

}  // namespace beadswim
