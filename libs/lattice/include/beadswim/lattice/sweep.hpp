#pragma once

#include <string>

#include "beadswim/lattice/populations.hpp"
#include "beadswim/lattice/trt.hpp"

namespace beadswim {

/// One step of the fluid in a block, row by row in any order: every own cell reads its 19 incoming
/// populations, collides them and puts its outgoing ones in their places. Branch-free: beads and walls have set
/// the incoming populations of a row's links before. The halo must have been filled (`row_ends` says what of
/// the next one is filled here: Halo::row_ends()).
///
/// The same bits on every instruction set and for every shape of block.
class BlockSweep {
 public:
  BlockSweep(Populations& populations, const RelaxationRates& rates, RowEnds row_ends);

  void row(int y, int z);

  /// All rows are swept: advances the populations.
  void finish();

 private:
  template <class Real>
  void row_as(int y, int z);
  const CollisionRates<double>& rates(double) const { return rates_fp64_; }
  const CollisionRates<float>& rates(float) const { return rates_fp32_; }

  Populations& populations_;
  CollisionRates<double> rates_fp64_;
  CollisionRates<float> rates_fp32_;
  RowEnds row_ends_;
};

/// All rows.
void stream_and_collide(Populations& populations, const RelaxationRates& rates,
                        RowEnds row_ends = RowEnds::left_to_halo);

/// The instruction set chosen on this processor: "x86-64-v4", "x86-64-v3" or "baseline".
std::string sweep_instruction_set();

}  // namespace beadswim
