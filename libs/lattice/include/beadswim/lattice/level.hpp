#pragma once

#include <array>
#include <vector>

#include "beadswim/core/box.hpp"
#include "beadswim/core/communicator.hpp"
#include "beadswim/lattice/block.hpp"
#include "beadswim/lattice/halo.hpp"
#include "beadswim/lattice/populations.hpp"
#include "beadswim/lattice/trt.hpp"

namespace beadswim {

/// Place of a level of cells in the box, in coordinates of its own cells.
struct LevelPlace {
  Block lattice;                       ///< cells of the level
  Index3 box;                          ///< number of cells of this size along each edge of the box
  std::array<Boundary, 3> boundary{};  ///< boundaries of the box

  bool spans(int axis) const { return lattice.size[axis] == box[axis]; }
  /// Returns the periodic image of a cell that lies in the lattice or, if there is none, an image of the cell
  /// outside the lattice.
  Index3 in_lattice(Index3 cell) const {
    for (int a = 0; a < 3; ++a) {
      if (boundary[a] != Boundary::periodic) continue;
      const int from_first = (cell[a] - lattice.offset[a]) % box[a];
      cell[a] = lattice.offset[a] + (from_first < 0 ? from_first + box[a] : from_first);
    }
    return cell;
  }
  /// Returns true if the lattice contains the cell or a periodic image of it.
  bool contains(const Index3& cell) const { return lattice.contains(in_lattice(cell)); }
  /// Returns the parts of a block of this level that lie under a finer level, in local coordinates of the
  /// block, sorted by x: one part for each periodic image of the finer level, which may be empty.
  std::vector<Block> parts_under(const LevelPlace& finer, const Block& block) const;
  /// Returns true if the level is periodic along the axis.
  bool is_periodic(int axis) const { return boundary[axis] == Boundary::periodic && spans(axis); }
};

/// Cells of one size: a box of cells, divided among all ranks, and the populations of the block of this rank.
/// Its cells are 1 long, and its steps last 1.
struct Level {
  Level(const LevelPlace& place_of_level, double relaxation_time, Precision precision, HaloContent content,
        const Communicator& communicator);

  LevelPlace place;
  Decomposition decomposition;
  Block block;
  Populations populations;
  Halo halo;
  RelaxationRates rates;
  /// Cells of the block under the next finer level, which are not in use, in local coordinates, sorted by x.
  std::vector<Block> refined;
};

}  // namespace beadswim
