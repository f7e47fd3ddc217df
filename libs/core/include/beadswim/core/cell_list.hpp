#pragma once

#include <algorithm>
#include <array>
#include <optional>
#include <span>
#include <vector>

#include "beadswim/core/box.hpp"
#include "beadswim/core/vec3.hpp"

namespace beadswim {

/// Sorts points into cells, so that pairs of points within a cutoff are found without a test of all pairs.
/// The edge of a cell is at least the cutoff over its reach, 1 or 2. All points within the cutoff of a point
/// are therefore in its own cell or at most `reach` cells away along each axis. Memory and construction time
/// are linear in the number of points.
class CellList {
 public:
  /// Builds the list.
  ///   positions  at least one point [length]; non-finite coordinates are allowed
  ///   cutoff     distance up to which pairs are found [length]
  ///   lengths    edges of the periodic box [length]; all 0 in open space
  ///   reach      1: few, long ranges of points; 2: fewer points beyond the cutoff
  CellList(std::span<const Vec3> positions, double cutoff, const Vec3& lengths, int reach = 2);

  bool is_periodic() const { return lengths_[0] > 0; }

  /// Returns the indices of all points, sorted by cell.
  const std::vector<int>& order() const { return order_; }

  /// Finds the points that may be within the cutoff of the point order()[s] and that come after it in
  /// order(). Calls visit(begin, end) for ranges of their indices t in order(), with begin <= t < end. Each
  /// of these indices is in exactly one range, so that calls of this function for all s visit each pair of
  /// close points once.
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
  /// First and last index of consecutive cells along one axis, both included. An index outside [0, counts_)
  /// refers to the cell of a periodic image.
  struct Range {
    int first, last;
  };
  /// Returns the cells along `axis` that may contain points within the cutoff of a point in the cell with
  /// index `at`. The range contains each cell once.
  Range neighbour_cells(int at, int axis) const {
    const int count = counts_[axis];
    if (is_periodic()) return count > 2 * reach_ ? Range{at - reach_, at + reach_} : Range{0, count - 1};
    return {std::max(0, at - reach_), std::min(count - 1, at + reach_)};
  }

  /// Calls visit(first, last) for ranges of consecutive cells, both included. Together the ranges contain
  /// `cell` and all other cells that may contain points within the cutoff of the points in `cell`. Each cell
  /// is in one range.
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
  int reach_;
  Vec3 low_ = Vec3::Zero();  ///< corner of the cells with the smallest coordinates
  std::array<double, 3> inverse_edge_{};
  std::array<int, 3> counts_{};  ///< number of cells along each axis
  std::vector<int> start_;       ///< first index of each cell in order_; last element: number of points
  std::vector<int> order_;
  std::vector<int> cell_;  ///< cell index of each point, in the order of order_
};

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
