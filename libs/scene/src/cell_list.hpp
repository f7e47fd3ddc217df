#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <unordered_map>
#include <vector>

#include "beadswim/core/box.hpp"
#include "beadswim/scene/bead_gaps.hpp"

namespace beadswim {

/// Cells at least `reach` wide, so that whatever lies within reach of a bead is in its cell or one of the 26
/// around it. Cells are hashed: an unbounded scene needs no more memory than its beads.
class CellList {
 public:
  CellList(const std::optional<Box>& domain, double reach) : width_(Vec3::Constant(reach)) {
    if (!domain) return;
    for (int axis = 0; axis < 3; ++axis) {
      if (!domain->is_periodic(axis)) continue;
      period_[axis] = std::max<std::int64_t>(1, clamped(std::floor(domain->lengths[axis] / reach)));
      width_[axis] = domain->lengths[axis] / static_cast<double>(period_[axis]);
    }
  }

  void insert(std::size_t bead, const Vec3& centre) { cells_[key(cell_of(centre))].push_back(bead); }

  /// Calls visit(bead) for each inserted bead that may be within reach, until it returns false; false then.
  template <typename Visit>
  bool visit_near(const Vec3& centre, Visit&& visit) const {
    for (const std::uint64_t near : keys_around(cell_of(centre))) {
      const auto cell = cells_.find(near);
      if (cell == cells_.end()) continue;
      for (const std::size_t bead : cell->second) {
        if (!visit(bead)) return false;
      }
    }
    return true;
  }

 private:
  using Cell = std::array<std::int64_t, 3>;

  static std::int64_t clamped(double x) { return static_cast<std::int64_t>(std::clamp(x, -1e15, 1e15)); }

  Cell cell_of(const Vec3& centre) const {
    return {clamped(std::floor(centre[0] / width_[0])), clamped(std::floor(centre[1] / width_[1])),
            clamped(std::floor(centre[2] / width_[2]))};
  }

  /// 21 bits an axis; cells that share a key cost time, never a pair.
  std::uint64_t key(const Cell& cell) const {
    std::uint64_t bits = 0;
    for (int axis = 0; axis < 3; ++axis) {
      const std::int64_t n = period_[axis];
      const std::int64_t folded = n > 0 ? ((cell[axis] % n) + n) % n : cell[axis];
      bits = (bits << 21) | (static_cast<std::uint64_t>(folded) & 0x1FFFFF);
    }
    return bits;
  }

  /// The keys of a cell and its neighbours, each once although a small periodic box has them several times.
  std::vector<std::uint64_t> keys_around(const Cell& cell) const {
    std::vector<std::uint64_t> keys;
    keys.reserve(27);
    for (int offset = 0; offset < 27; ++offset) {
      keys.push_back(key({cell[0] + offset % 3 - 1, cell[1] + offset / 3 % 3 - 1, cell[2] + offset / 9 - 1}));
    }
    std::sort(keys.begin(), keys.end());
    keys.erase(std::unique(keys.begin(), keys.end()), keys.end());
    return keys;
  }

  Vec3 width_;
  std::array<std::int64_t, 3> period_{};  // cells along a periodic axis; 0 on others
  std::unordered_map<std::uint64_t, std::vector<std::size_t>> cells_;
};

inline double largest_radius(const std::vector<PlacedBead>& beads) {
  double radius = 0;
  for (const PlacedBead& bead : beads) radius = std::max(radius, bead.radius);
  return radius;
}

/// Calls visit(pair) for each pair of beads, and maybe some more, whose nearest images are within `reach`
/// between centres, until it returns false.
template <typename Visit>
void visit_close_pairs(const std::vector<PlacedBead>& beads, const std::optional<Box>& domain, double reach,
                       Visit&& visit) {
  CellList cells(domain, reach);
  for (std::size_t i = 0; i < beads.size(); ++i) {
    const bool go_on = cells.visit_near(beads[i].centre, [&](std::size_t j) {
      return visit(BeadPair{i, j, nearest_separation(beads[i].centre, beads[j].centre, domain).norm()});
    });
    if (!go_on) return;
    cells.insert(i, beads[i].centre);
  }
}

}  // namespace beadswim
