#pragma once

#include <array>
#include <vector>

#include "beadswim/core/vec3.hpp"

// Decomposition of the lattice into blocks of cells, one block per rank.

namespace beadswim {

/// The box of cells [offset, offset + size) of the complete lattice [cell].
struct Block {
  Index3 offset = Index3::Zero();
  Index3 size = Index3::Zero();

  bool contains(const Index3& cell) const { return (cell >= offset).all() && (cell < offset + size).all(); }
};

/// A Cartesian grid of blocks; rank b owns block b. Every rank stores the complete grid and finds the owner
/// of a cell without communication.
class Decomposition {
 public:
  /// Divides a lattice of `cells` cells into `ranks` blocks of nearly equal size. Chooses the grid with the
  /// cheapest halo exchange: cuts across y and z cost less than cuts across x. Throws InputError if no grid
  /// gives every rank at least one cell.
  Decomposition(const Index3& cells, int ranks);

  const Index3& cells() const { return cells_; }
  const Index3& grid() const { return grid_; }
  int ranks() const { return grid_.prod(); }
  Block block(int rank) const;
  Index3 grid_position(int rank) const;
  int rank_at(const Index3& grid_position) const;  ///< requires 0 <= grid_position < grid()
  int rank_of_cell(const Index3& cell) const;      ///< requires 0 <= cell < cells()

 private:
  Index3 cells_;
  Index3 grid_;
};

}  // namespace beadswim
