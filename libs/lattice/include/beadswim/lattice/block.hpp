#pragma once

#include <span>
#include <vector>

#include "beadswim/core/fields.hpp"
#include "beadswim/core/vec3.hpp"

// Decomposition of a lattice into blocks of cells, one block per MPI rank.

namespace beadswim {

/// Block of cells: the cells with offset <= index < offset + size along each axis [cell].
struct Block {
  Index3 offset = Index3::Zero();
  Index3 size = Index3::Zero();

  BEADSWIM_FIELDS(offset, size)

  Index3 end() const { return offset + size; }
  bool operator==(const Block& other) const {
    return (offset == other.offset).all() && (size == other.size).all();
  }
  bool is_empty() const { return (size <= 0).any(); }
  bool contains(const Index3& cell) const { return (cell >= offset).all() && (cell < end()).all(); }

  static int floor_half(int n) { return n >= 0 ? n / 2 : -((1 - n) / 2); }
  /// Returns the block of cells of twice the size that contains this block.
  Block halved() const {
    const Index3 low = offset.unaryExpr(&floor_half), last = (end() - 1).unaryExpr(&floor_half);
    return {.offset = low, .size = last - low + 1};
  }
  /// Returns the same block in cells of half the size.
  Block doubled() const { return {.offset = 2 * offset, .size = 2 * size}; }
  /// Returns the block with a layer of cells around it.
  Block widened() const { return {.offset = offset - 1, .size = size + 2}; }
};

/// Calls visit(cell) for all cells of a block, x fastest.
template <class Visit>
void for_each_cell(const Block& block, Visit&& visit) {
  for (int z = block.offset[2]; z < block.end()[2]; ++z) {
    for (int y = block.offset[1]; y < block.end()[1]; ++y) {
      for (int x = block.offset[0]; x < block.end()[0]; ++x) visit(Index3(x, y, z));
    }
  }
}

/// Calls visit(first, end) for all runs of cells of row (y, z) outside `parts`, which are sorted by x.
/// `cells`: length of the row.
template <class Visit>
void for_each_run_outside(std::span<const Block> parts, int cells, int y, int z, Visit&& visit) {
  int first = 0;
  for (const Block& part : parts) {
    if (!part.contains({part.offset[0], y, z})) continue;
    if (first < part.offset[0]) visit(first, part.offset[0]);
    first = part.end()[0];
  }
  if (first < cells) visit(first, cells);
}

/// Cells that ranks share, and the smallest permitted number of cells of a block along each axis.
struct SharedCells {
  Index3 cells;
  int thickness = 1;
};
/// Throws InputError if there is no grid of `ranks` blocks for one of several lattices. The message names the
/// largest smaller number of ranks for which all lattices have a grid.
void require_grids(const std::vector<SharedCells>& lattices, int ranks);

/// A Cartesian grid of blocks; rank b owns block b. Every rank stores the complete grid and finds the owner
/// of a cell without communication.
class Decomposition {
 public:
  /// Divides the cells of a lattice into `ranks` blocks of nearly equal size. Chooses the numbers of
  /// blocks along x, y and z for which the exchange of halo cells is cheapest. Cuts perpendicular to y or z
  /// cost less than cuts perpendicular to x. `thickness`: smallest permitted number of cells of a block along
  /// each axis. Throws InputError as require_grids().
  Decomposition(const Index3& cells, int ranks) : Decomposition(Block{.size = cells}, ranks) {}
  Decomposition(const Block& lattice, int ranks, int thickness = 1);

  const Block& lattice() const { return lattice_; }
  const Index3& cells() const { return lattice_.size; }
  const Index3& grid() const { return grid_; }
  int ranks() const { return grid_.prod(); }
  Block block(int rank) const;
  Index3 grid_position(int rank) const;
  int rank_at(const Index3& grid_position) const;  ///< requires 0 <= grid_position < grid()
  int rank_of_cell(const Index3& cell) const;      ///< requires lattice().contains(cell)

 private:
  Block lattice_;
  Index3 grid_;
};

}  // namespace beadswim
