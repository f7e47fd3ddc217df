#pragma once

#include <memory>
#include <span>
#include <string>

#include "beadswim/lattice/block.hpp"
#include "beadswim/lattice/populations.hpp"
#include "beadswim/lattice/trt.hpp"

namespace beadswim {

/// Advances the fluid of a block by one step, row by row. The rows may be swept in any order. Each cell of
/// the block reads its 19 incoming populations, collides them and writes its 19 outgoing populations. The
/// loop has no branches. Before a row is swept, all incoming populations of its cells must be set: by
/// boundary conditions where they come from walls and beads, and by the halo where they come from outside the
/// block. `row_ends` selects how the sweep fills the halo cells at the ends of the row for the next step
/// (Halo::row_ends()). `body_force`: momentum that each cell gains in this step (body_force.hpp). `skipped`:
/// cells that the sweep leaves as they are, in local coordinates, sorted by x.
///
/// The results have the same bits for every instruction set and every shape of block.
class BlockSweep {
 public:
  BlockSweep(Populations& populations, const RelaxationRates& rates, RowEnds row_ends,
             const Vec3& body_force = Vec3::Zero(), std::span<const Block> skipped = {});
  ~BlockSweep();

  /// Sweeps the row (y, z).
  void row(int y, int z);

  /// Completes the step: changes the parity of the populations (Populations::advance()). Call it after all
  /// rows have been swept.
  void finish();

 private:
  template <class Real>
  void row_as(int y, int z);

  struct Rows;

  Populations& populations_;
  RowEnds row_ends_;
  std::span<const Block> skipped_;
  std::unique_ptr<Rows> rows_;
};

/// Sweeps all rows of a block.
void stream_and_collide(Populations& populations, const RelaxationRates& rates,
                        RowEnds row_ends = RowEnds::left_to_halo, const Vec3& body_force = Vec3::Zero());

/// Returns the body force that may act instead of `body_force` on populations of this precision. In single
/// precision it has so few binary digits that a population takes it up without rounding. Other errors would
/// not average out, because they are equal in many cells and steps.
Vec3 acting_body_force(const Vec3& body_force, Precision precision);

/// Returns the instruction set that the kernels use on this processor: "x86-64-v4", "x86-64-v3" or
/// "baseline".
std::string sweep_instruction_set();

}  // namespace beadswim
