#pragma once

#include <array>
#include <vector>

#include "beadswim/core/vec3.hpp"

// Decomposition of the lattice into blocks of cells, one block per MPI rank.

namespace beadswim {

/// Block of cells that one MPI rank owns: the cells of the lattice with offset <= index < offset + size along
/// each axis [cell].
struct Block {
  Index3 offset = Index3::Zero();
  Index3 size = Index3::Zero();

  bool contains(const Index3& cell) const { return (cell >= offset).all() && (cell < offset + size).all(); }
};

/// A Cartesian grid of blocks; rank b owns block b. Every rank stores the complete grid and finds the owner
/// of a cell without communication.
class Decomposition {
 public:
  /// Divides a lattice of `cells` cells into `ranks` blocks of nearly equal size. Chooses the numbers of
  /// blocks along x, y and z for which the exchange of halo cells is cheapest. Cuts perpendicular to y or z
  /// cost less than cuts perpendicular to x. Throws InputError if no grid of blocks gives every rank at least
  /// one cell.
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
