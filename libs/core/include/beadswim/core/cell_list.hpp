#pragma once

#include <algorithm>
#include <array>
#include <span>
#include <vector>

#include "beadswim/core/vec3.hpp"

namespace beadswim {

/// Points in space, sorted into cells, to find those within a cutoff of one another. An edge of a cell is at
/// least half the cutoff, so that all neighbours of a point are in its cell and in the two cells on each
/// side. Memory and time to build are linear in the number of points.
class CellList {
 public:
  /// `positions` holds at least one point; non-finite coordinates are allowed. `lengths`: edges of the
  /// periodic box, all 0 in open space [length].
  CellList(std::span<const Vec3> positions, double cutoff, const Vec3& lengths);

  bool is_periodic() const { return lengths_[0] > 0; }

  /// Returns the indices of the points in the order of their cells.
  const std::vector<int>& order() const { return order_; }

  /// Calls visit(begin, end) for ranges of order(). Together they hold each point after order()[s] that may
  /// be within the cutoff of it, once.
  template <class Visitor>
  void for_each_stretch_after(int s, const Visitor& visit) const {
    const int own = cell_[s];
    for_each_row_around(own, [&](int first, int last) {
      if (last >= own) visit(first <= own ? s + 1 : start_[first], start_[last + 1]);
    });
  }

  /// Calls visit(index) for each point that may be within the cutoff of `position`, which need not be a point
  /// of the list, until visit returns false. Returns whether it never did.
  template <class Visitor>
  bool visit_near(const Vec3& position, const Visitor& visit) const {
    bool goes_on = true;
    for_each_row_around(cell_of(position), [&](int first, int last) {
      for (int s = start_[first]; goes_on && s < start_[last + 1]; ++s)
        goes_on = visit(static_cast<std::size_t>(order_[s]));
    });
    return goes_on;
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

  /// Calls visit(first, last) for ranges of cells that together hold `cell` and its neighbours, each once.
  template <class Visitor>
  void for_each_row_around(int cell, const Visitor& visit) const {
    const Range x = around(cell / (counts_[1] * counts_[2]), 0);
    const Range y = around(cell / counts_[2] % counts_[1], 1);
    const Range z = around(cell % counts_[2], 2);
    for (int i = x.first; i <= x.last; ++i)
      for (int j = y.first; j <= y.last; ++j) {
        const int row = (folded(i, 0) * counts_[1] + folded(j, 1)) * counts_[2];
        visit(row + std::max(z.first, 0), row + std::min(z.last, counts_[2] - 1));
        if (z.first < 0) visit(row + z.first + counts_[2], row + counts_[2] - 1);
        if (z.last >= counts_[2]) visit(row, row + z.last - counts_[2]);
      }
  }

  int folded(int i, int axis) const { return (i + counts_[axis]) % counts_[axis]; }
  int cell_of(const Vec3& position) const;

  Vec3 lengths_;
  Vec3 low_ = Vec3::Zero();  ///< lowest corner of the cells
  std::array<double, 3> inverse_edge_{};
  std::array<int, 3> counts_{};  ///< cells along each axis
  std::vector<int> start_;       ///< of each cell in order_, and the end
  std::vector<int> order_;
  std::vector<int> cell_;  ///< cell of each point of order_
};

}  // namespace beadswim
