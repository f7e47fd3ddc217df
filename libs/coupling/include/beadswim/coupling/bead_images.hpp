#pragma once

#include <algorithm>
#include <array>

#include "beadswim/core/box.hpp"
#include "beadswim/core/vec3.hpp"
#include "beadswim/lattice/block.hpp"

// Where a bead, whose coordinates are never wrapped, meets a block of a lattice that may be periodic.

namespace beadswim {

/// Cells [low, high) of a block, in local coordinates (-margin to size + margin), that an image of a bead may
/// cover. Cell p of the block is cell p + shift in the bead's own unwrapped coordinates.
struct BeadImage {
  Index3 low, high;
  Index3 shift;
};

/// Whether cells of one box may be within `distance` cells of cells of the other.
inline bool are_close(const BeadImage& a, const BeadImage& b, int distance) {
  return (a.low < b.high + distance).all() && (b.low < a.high + distance).all();
}

/// The lattice as seen by beads: its size, what closes it, and one block of it.
struct BlockInLattice {
  Block block;
  Index3 cells;
  std::array<Boundary, 3> boundary;  ///< of the lattice

  bool is_periodic(int axis) const { return boundary[axis] == Boundary::periodic; }
};

BlockInLattice block_in_lattice(const Decomposition& decomposition, int rank,
                                const std::array<Boundary, 3>& boundary);

namespace detail {

struct Interval {
  int low, high, shift;
};

/// Calls visit(Interval) for each periodic image of the unwrapped cells [low, high) on a block's axis that
/// meets its cells [-margin, size + margin).
template <class Visit>
void for_each_image_on_axis(const BlockInLattice& at, int axis, int margin, int low, int high,
                            Visit&& visit) {
  const int offset = at.block.offset[axis], size = at.block.size[axis], period = at.cells[axis];
  const auto visit_if_met = [&](int shift) {  // unwrapped = local + shift
    const int first = std::max(low - shift, -margin), end = std::min(high - shift, size + margin);
    if (first < end) visit(Interval{first, end, shift});
  };
  if (!at.is_periodic(axis)) return visit_if_met(offset);
  const int lowest = low - (size + margin) - offset, highest = high + margin - offset;
  const auto floor_division = [](int a, int b) { return a >= 0 ? a / b : -((-a + b - 1) / b); };
  for (int k = floor_division(lowest, period); k * period <= highest; ++k) visit_if_met(offset + k * period);
}

}  // namespace detail

/// Calls visit(BeadImage) for every image of a bead that may cover cells of the block or of `margin` cells
/// around it.
template <class Visit>
void for_each_image(const BlockInLattice& at, int margin, const Vec3& position, double radius,
                    Visit&& visit) {
  // Cell i has its centre at i + 1/2.
  const Index3 low = (position.array() - (radius + 0.5)).ceil().cast<int>();
  const Index3 high = (position.array() + (radius - 0.5)).floor().cast<int>() + 1;
  using detail::Interval;
  detail::for_each_image_on_axis(at, 2, margin, low[2], high[2], [&](const Interval& z) {
    detail::for_each_image_on_axis(at, 1, margin, low[1], high[1], [&](const Interval& y) {
      detail::for_each_image_on_axis(at, 0, margin, low[0], high[0], [&](const Interval& x) {
        visit(BeadImage{.low = {x.low, y.low, z.low},
                        .high = {x.high, y.high, z.high},
                        .shift = {x.shift, y.shift, z.shift}});
      });
    });
  });
}

/// Whether any image of the bead may cover a cell of the block or of `margin` cells around it.
bool touches(const BlockInLattice& at, int margin, const Vec3& position, double radius);

}  // namespace beadswim
