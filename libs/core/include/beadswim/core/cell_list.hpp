#pragma once

#include <algorithm>
#include <array>
#include <span>
#include <vector>

#include "beadswim/core/vec3.hpp"

namespace beadswim {

/// Sorts points into cells, in order to find pairs of points within a cutoff. The edge of a cell is at least
/// half the cutoff. All neighbours of a point are therefore in its own cell or at most two cells away along
/// each axis. Memory and construction time are linear in the number of points.
class CellList {
 public:
  /// Builds the list.
  ///   positions  at least one point [length]; non-finite coordinates are allowed
  ///   cutoff     [length]
  ///   lengths    edges of the periodic box [length]; all 0 in open space
  CellList(std::span<const Vec3> positions, double cutoff, const Vec3& lengths);

  bool is_periodic() const { return lengths_[0] > 0; }

  /// Returns the indices of the points in the order of their cells.
  const std::vector<int>& order() const { return order_; }

  /// Calls visit(begin, end) for ranges of positions in order(). Together the ranges contain, once each, all
  /// points after position s that may be within the cutoff of the point order()[s].
  template <class Visitor>
  void for_each_range_after(int s, const Visitor& visit) const {
    const int own = cell_[s];
    for_each_row_around(own, [&](int first, int last) {
      if (last >= own) visit(first <= own ? s + 1 : start_[first], start_[last + 1]);
    });
  }

  /// Calls visit(index) for each point that may be within the cutoff of `position`, until visit returns
  /// false. `position` need not be a point of the list. Returns true if no call returned false.
  template <class Visitor>
  bool visit_neighbours(const Vec3& position, const Visitor& visit) const {
    bool continues = true;
    for_each_row_around(cell_of(position), [&](int first, int last) {
      for (int s = start_[first]; continues && s < start_[last + 1]; ++s)
        continues = visit(static_cast<std::size_t>(order_[s]));
    });
    return continues;
  }

 private:
  /// Indices of consecutive cells along one axis, `last` included. An index outside [0, counts_) stands for
  /// the cell of a periodic image.
  struct Range {
    int first, last;
  };
  /// Returns the cells along `axis` that may contain neighbours of a point in cell `at`, each cell once.
  Range neighbour_cells(int at, int axis) const {
    const int count = counts_[axis];
    if (is_periodic()) return count >= 5 ? Range{at - 2, at + 2} : Range{0, count - 1};
    return {std::max(0, at - 2), std::min(count - 1, at + 2)};
  }

  /// Calls visit(first, last) for ranges of cells. Together the ranges contain, once each, `cell` and all
  /// cells that may contain neighbours of its points.
  template <class Visitor>
  void for_each_row_around(int cell, const Visitor& visit) const {
    const Range x = neighbour_cells(cell / (counts_[1] * counts_[2]), 0);
    const Range y = neighbour_cells(cell / counts_[2] % counts_[1], 1);
    const Range z = neighbour_cells(cell % counts_[2], 2);
    for (int i = x.first; i <= x.last; ++i)
      for (int j = y.first; j <= y.last; ++j) {
        const int row = (wrap_index(i, 0) * counts_[1] + wrap_index(j, 1)) * counts_[2];
        visit(row + std::max(z.first, 0), row + std::min(z.last, counts_[2] - 1));
        if (z.first < 0) visit(row + z.first + counts_[2], row + counts_[2] - 1);
        if (z.last >= counts_[2]) visit(row, row + z.last - counts_[2]);
      }
  }

  int wrap_index(int i, int axis) const { return (i + counts_[axis]) % counts_[axis]; }
  int cell_of(const Vec3& position) const;

  Vec3 lengths_;
  Vec3 low_ = Vec3::Zero();  ///< lowest corner of the cells
  std::array<double, 3> inverse_edge_{};
  std::array<int, 3> counts_{};  ///< cells along each axis
  std::vector<int> start_;       ///< position in order_ at which each cell starts; last entry: size of order_
  std::vector<int> order_;
  std::vector<int> cell_;  ///< cell of each point, in the order of order_
};

}  // namespace beadswim
