#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <vector>

#include "beadswim/core/vec3.hpp"
#include "beadswim/mobility/bounds.hpp"

// Beads sorted into cells of at least half a cut-off's edge, so that all neighbours of one are in its cell
// and two around it.

namespace beadswim {

class NeighbourCells {
 public:
  /// lengths: of the periodic box; 0: open space.
  NeighbourCells(std::span<const Vec3> positions, double cut_off, const Vec3& lengths) : lengths_(lengths) {
    const Bounds bounds(positions);
    if (!is_periodic()) low_ = bounds.low;
    for (int a = 0; a < 3; ++a) {
      const double extent = is_periodic() ? lengths_[a] : bounds.high[a] - bounds.low[a];
      // No more cells than a row of all beads would need: memory stays linear in their number.
      const double most = std::cbrt(8.0 * static_cast<double>(positions.size())) + 1;
      const bool is_finite = std::isfinite(extent);  // of places that are no numbers one cell is left
      counts_[a] = is_finite ? static_cast<int>(std::clamp(std::floor(2 * extent / cut_off), 1.0, most)) : 1;
      inverse_edge_[a] = is_finite && extent > 0 ? counts_[a] / extent : 0;
    }
    sort(positions);
  }

  bool is_periodic() const { return lengths_[0] > 0; }

  /// Beads in order of their cells.
  const std::vector<int>& order() const { return order_; }

  /// Calls visit(begin, end) for stretches of order() that together hold each bead after place s that may be
  /// near it, once.
  template <class Visitor>
  void for_each_stretch_after(int s, const Visitor& visit) const {
    const int own = cell_[s];
    const std::array<int, 3> at{own / (counts_[1] * counts_[2]), own / counts_[2] % counts_[1],
                                own % counts_[2]};
    const auto visit_cells = [&](int first, int last) {  // of a row, those after the own
      if (last < own) return;
      visit(first <= own ? s + 1 : start_[first], start_[last + 1]);
    };
    const Range x = around(at[0], 0), y = around(at[1], 1), z = around(at[2], 2);
    for (int i = x.first; i <= x.last; ++i)
      for (int j = y.first; j <= y.last; ++j) {
        const int row = (folded(i, 0) * counts_[1] + folded(j, 1)) * counts_[2];
        visit_cells(row + std::max(z.first, 0), row + std::min(z.last, counts_[2] - 1));
        if (z.first < 0) visit_cells(row + z.first + counts_[2], row + counts_[2] - 1);
        if (z.last >= counts_[2]) visit_cells(row, row + z.last - counts_[2]);
      }
  }

 private:
  /// Cells along an axis, each once; outside of 0 to counts_ where they wrap.
  struct Range {
    int first, last;
  };
  Range around(int at, int axis) const {
    const int count = counts_[axis];
    if (is_periodic()) return count >= 5 ? Range{at - 2, at + 2} : Range{0, count - 1};
    return {std::max(0, at - 2), std::min(count - 1, at + 2)};
  }
  int folded(int i, int axis) const { return (i + counts_[axis]) % counts_[axis]; }
  int index(const std::array<int, 3>& c) const { return (c[0] * counts_[1] + c[1]) * counts_[2] + c[2]; }

  int cell_of(const Vec3& x) const {
    std::array<int, 3> c;
    for (int a = 0; a < 3; ++a) {
      double place = x[a] - low_[a];
      if (is_periodic()) place -= lengths_[a] * std::floor(place / lengths_[a]);
      const double cell = place * inverse_edge_[a];
      c[a] = cell > 0 ? static_cast<int>(std::min(cell, counts_[a] - 1.0)) : 0;
    }
    return index(c);
  }

  void sort(std::span<const Vec3> positions) {
    start_.assign(std::size_t(counts_[0]) * counts_[1] * counts_[2] + 1, 0);
    std::vector<int> cell(positions.size());
    for (std::size_t b = 0; b < positions.size(); ++b) ++start_[(cell[b] = cell_of(positions[b])) + 1];
    for (std::size_t c = 1; c < start_.size(); ++c) start_[c] += start_[c - 1];
    std::vector<int> next = start_;
    order_.resize(positions.size());
    cell_.resize(positions.size());
    for (std::size_t b = 0; b < positions.size(); ++b) {
      const int s = next[cell[b]]++;
      order_[s] = static_cast<int>(b);
      cell_[s] = cell[b];
    }
  }

  Vec3 lengths_;
  Vec3 low_ = Vec3::Zero();
  std::array<double, 3> inverse_edge_{};
  std::array<int, 3> counts_{};
  std::vector<int> start_;         ///< of each cell in order_, and the end
  std::vector<int> order_, cell_;  ///< cell_: of each place in order_
};

}  // namespace beadswim
