#pragma once

#include <memory>
#include <string>

#include "beadswim/lattice/populations.hpp"
#include "beadswim/lattice/trt.hpp"

namespace beadswim {

/// Advances the fluid of a block by one step, row by row. The rows may be swept in any order. Each cell of
/// the block reads its 19 incoming populations, collides them and writes its 19 outgoing populations. The
/// loop has no branches. Before a row is swept, the boundary conditions must have set the incoming
/// populations of its links, and the halo cells that it reads must have been filled. `row_ends` selects the
/// halo cells of the next step that the sweep fills itself (Halo::row_ends()).
///
/// The results have the same bits for every instruction set and every shape of block.
class BlockSweep {
 public:
  BlockSweep(Populations& populations, const RelaxationRates& rates, RowEnds row_ends);
  ~BlockSweep();

  /// Sweeps the row (y, z).
  void row(int y, int z);

  /// Changes the parity of the populations. Call it after all rows have been swept.
  void finish();

 private:
  template <class Real>
  void row_as(int y, int z);

  struct Rows;

  Populations& populations_;
  RowEnds row_ends_;
  std::unique_ptr<Rows> rows_;
};

/// Sweeps all rows of a block.
void stream_and_collide(Populations& populations, const RelaxationRates& rates,
                        RowEnds row_ends = RowEnds::left_to_halo);

/// Returns the instruction set that the kernels use on this processor: "x86-64-v4", "x86-64-v3" or
/// "baseline".
std::string sweep_instruction_set();

}  // namespace beadswim
