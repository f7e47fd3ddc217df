#include "beadswim/core/cell_list.hpp"

#include <cmath>

namespace beadswim {

CellList::CellList(std::span<const Vec3> positions, double cutoff, const Vec3& lengths, int reach)
    : lengths_(lengths), reach_(reach) {
  const Eigen::AlignedBox3d bounds = bounding_box(positions);
  if (!is_periodic()) low_ = bounds.min();
  // `max_count` is an upper bound of the number of cells along each axis. It limits the number of all cells
  // to about eight per point, so that memory is linear in the number of points.
  const double max_count = std::cbrt(8.0 * static_cast<double>(positions.size())) + 1;
  for (int a = 0; a < 3; ++a) {
    const double extent = is_periodic() ? lengths_[a] : bounds.sizes()[a];
    const bool is_finite = std::isfinite(extent);  // if false, one cell contains all points along this axis
    counts_[a] =
        is_finite ? static_cast<int>(std::clamp(std::floor(reach * extent / cutoff), 1.0, max_count)) : 1;
    inverse_edge_[a] = is_finite && extent > 0 ? counts_[a] / extent : 0;
  }

  start_.assign(std::size_t(counts_[0]) * counts_[1] * counts_[2] + 1, 0);
  std::vector<int> cells(positions.size());
  for (std::size_t i = 0; i < positions.size(); ++i) ++start_[(cells[i] = cell_of(positions[i])) + 1];
  for (std::size_t c = 1; c < start_.size(); ++c) start_[c] += start_[c - 1];
  std::vector<int> next = start_;
  order_.resize(positions.size());
  cell_.resize(positions.size());
  for (std::size_t i = 0; i < positions.size(); ++i) {
    const int s = next[cells[i]]++;
    order_[s] = static_cast<int>(i);
    cell_[s] = cells[i];
  }
}

int CellList::cell_of(const Vec3& position) const {
  std::array<int, 3> c;
  for (int a = 0; a < 3; ++a) {
    double place = position[a] - low_[a];
    if (is_periodic()) place -= lengths_[a] * std::floor(place / lengths_[a]);
    const double cell = place * inverse_edge_[a];
    c[a] = cell > 0 ? static_cast<int>(std::min(cell, counts_[a] - 1.0)) : 0;
  }
  return (c[0] * counts_[1] + c[1]) * counts_[2] + c[2];
}

}  // namespace beadswim
