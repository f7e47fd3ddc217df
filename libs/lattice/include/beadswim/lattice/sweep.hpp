#pragma once

#include <memory>
#include <string>

#include "beadswim/lattice/populations.hpp"
#include "beadswim/lattice/trt.hpp"

namespace beadswim {

/// One step of the fluid in a block, row by row in any order: every own cell reads its 19 incoming
/// populations, collides them and puts its outgoing ones in their places. Branch-free: beads and walls have
/// set the incoming populations of a row's links before. The halo beside a row must have been filled before
/// it is swept (`row_ends` says what of the next one is filled here: Halo::row_ends()).
///
/// The same bits on every instruction set and for every shape of block.
class BlockSweep {
 public:
  BlockSweep(Populations& populations, const RelaxationRates& rates, RowEnds row_ends);
  ~BlockSweep();

  void row(int y, int z);

  /// All rows are swept: advances the populations.
  void finish();

 private:
  template <class Real>
  void row_as(int y, int z);

  struct Rows;

  Populations& populations_;
  RowEnds row_ends_;
  std::unique_ptr<Rows> rows_;
};

/// All rows.
void stream_and_collide(Populations& populations, const RelaxationRates& rates,
                        RowEnds row_ends = RowEnds::left_to_halo);

/// The instruction set chosen on this processor: "x86-64-v4", "x86-64-v3" or "baseline".
std::string sweep_instruction_set();

}  // namespace beadswim
