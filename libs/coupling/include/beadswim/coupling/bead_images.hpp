#pragma once

#include <algorithm>
#include <array>

#include "beadswim/core/box.hpp"
#include "beadswim/core/vec3.hpp"
#include "beadswim/lattice/block.hpp"

// Periodic images of a bead in a block of the lattice. The coordinates of a bead are never wrapped into the
// box.

namespace beadswim {

/// One periodic image of a bead. The image may cover cells in the box [low, high), in local coordinates of
/// the block. The box is limited to the block and `margin` layers of cells around it. The cell with local
/// coordinates p has the coordinates p + shift in the unwrapped coordinates of the bead.
struct BeadImage {
  Index3 low, high;
  Index3 shift;
};

/// Returns true if along every axis the coordinates of the nearest cells of the boxes of two images differ by
/// at most `distance`. If `distance` is 0, the boxes must share cells.
inline bool are_close(const BeadImage& a, const BeadImage& b, int distance) {
  return (a.low < b.high + distance).all() && (b.low < a.high + distance).all();
}

/// A block, and the size [cell] and boundaries of the box that contains it.
struct BlockInLattice {
  Block block;
  Index3 cells;
  std::array<Boundary, 3> boundary;

  bool is_periodic(int axis) const { return boundary[axis] == Boundary::periodic; }
};

namespace detail {

/// Cells [low, high) along one axis, in local coordinates of the block. A cell with local coordinate x has
/// the unwrapped coordinate x + shift.
struct Interval {
  int low, high, shift;
};

/// Calls visit(Interval) for each periodic image of the unwrapped cells [low, high) that overlaps the cells
/// [-margin, size + margin) of a block along `axis`.
template <class Visit>
void for_each_image_on_axis(const BlockInLattice& lattice_block, int axis, int margin, int low, int high,
                            Visit&& visit) {
  const int offset = lattice_block.block.offset[axis], size = lattice_block.block.size[axis],
            period = lattice_block.cells[axis];
  const auto visit_if_overlapping = [&](int shift) {  // unwrapped = local + shift
    const int first = std::max(low - shift, -margin), end = std::min(high - shift, size + margin);
    if (first < end) visit(Interval{.low = first, .high = end, .shift = shift});
  };
  if (!lattice_block.is_periodic(axis)) return visit_if_overlapping(offset);
  const int lowest = low - (size + margin) - offset, highest = high + margin - offset;
  const auto floor_division = [](int a, int b) { return a >= 0 ? a / b : -((-a + b - 1) / b); };
  for (int k = floor_division(lowest, period); k * period <= highest; ++k)
    visit_if_overlapping(offset + k * period);
}

}  // namespace detail

/// Calls visit(BeadImage) for every image of a bead that may cover cells of the block or of the `margin`
/// layers of cells around it.
template <class Visit>
void for_each_image(const BlockInLattice& lattice_block, int margin, const Vec3& position, double radius,
                    Visit&& visit) {
  // Cell i has its centre at i + 1/2.
  const Index3 low = (position.array() - (radius + 0.5)).ceil().cast<int>();
  const Index3 high = (position.array() + (radius - 0.5)).floor().cast<int>() + 1;
  using detail::Interval;
  detail::for_each_image_on_axis(lattice_block, 2, margin, low[2], high[2], [&](const Interval& z) {
    detail::for_each_image_on_axis(lattice_block, 1, margin, low[1], high[1], [&](const Interval& y) {
      detail::for_each_image_on_axis(lattice_block, 0, margin, low[0], high[0], [&](const Interval& x) {
        visit(BeadImage{.low = {x.low, y.low, z.low},
                        .high = {x.high, y.high, z.high},
                        .shift = {x.shift, y.shift, z.shift}});
      });
    });
  });
}

}  // namespace beadswim
