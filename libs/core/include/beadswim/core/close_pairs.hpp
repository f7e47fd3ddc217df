#pragma once

#include <optional>
#include <span>
#include <vector>

#include "beadswim/core/box.hpp"
#include "beadswim/core/cell_list.hpp"

namespace beadswim {

/// Calls visit(i, j, d) for each pair of points that may be within `cutoff` of each other along every axis
/// [length], until visit returns false. Periodic images are included, pairs across walls are not. Each pair
/// is visited once, in the order of the cells of a CellList.
///   i, j  indices of the two points
///   d     vector from point j to the nearest image of point i [length]
template <class Visit>
void visit_close_pairs(std::span<const Vec3> positions, double cutoff, const std::optional<Box>& box,
                       const Visit& visit) {
  if (positions.empty()) return;
  const CellList cells(positions, cutoff, mirrored_lengths(box));
  const std::vector<int>& order = cells.order();
  bool continues = true;
  for (int s = 0; continues && s < static_cast<int>(order.size()); ++s) {
    const int i = order[s];
    cells.for_each_range_after(s, [&](int begin, int end) {
      for (int t = begin; continues && t < end; ++t) {
        const int j = order[t];
        continues = visit(i, j, nearest_separation(positions[j], positions[i], box));
      }
    });
  }
}

}  // namespace beadswim
