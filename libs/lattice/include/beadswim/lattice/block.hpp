#pragma once

#include <array>
#include <vector>

#include "beadswim/core/vec3.hpp"

// How the box of cells is cut into blocks.

namespace beadswim {

/// A box of cells [offset, offset + size) of the whole lattice.
struct Block {
  Index3 offset = Index3::Zero();
  Index3 size = Index3::Zero();

  bool contains(const Index3& cell) const { return (cell >= offset).all() && (cell < offset + size).all(); }
};

/// A Cartesian grid of blocks, block b on rank b. Every rank knows all of it, so that owners of cells are
/// found without a message.
class Decomposition {
 public:
  /// Cuts `cells` into `ranks` blocks of nearly equal size with the cheapest surfaces: across y and z rather
  /// than x. Throws InputError if there are more ranks than can have a cell each.
  Decomposition(const Index3& cells, int ranks);

  const Index3& cells() const { return cells_; }
  const Index3& grid() const { return grid_; }
  int ranks() const { return grid_.prod(); }
  Block block(int rank) const;
  Index3 grid_position(int rank) const;
  int rank_at(const Index3& grid_position) const;  ///< grid position within the grid
  int rank_of_cell(const Index3& cell) const;      ///< cell within the lattice

 private:
  Index3 cells_;
  Index3 grid_;
};

}  // namespace beadswim
