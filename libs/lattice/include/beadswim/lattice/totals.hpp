#pragma once

#include <array>
#include <span>

#include "beadswim/core/communicator.hpp"
#include "beadswim/core/order_free_sum.hpp"
#include "beadswim/lattice/block.hpp"
#include "beadswim/lattice/populations.hpp"

namespace beadswim {

/// Total mass and momentum of a set of cells. The bits do not depend on the decomposition of the lattice.
struct FluidTotals {
  OrderFreeSum density_deviation;        ///< sum of (density - 1) over the cells
  std::array<OrderFreeSum, 3> momentum;  ///< sum of velocity c_i times population f_i over i and cells

  /// Adds the moments of one cell. Throws SolverError if a moment is non-finite or too large for
  /// OrderFreeSum.
  void add(const CellMoments& moments);
  void add(const FluidTotals& other);
  void subtract(const FluidTotals& other);

  Vec3 momentum_value() const { return {momentum[0].value(), momentum[1].value(), momentum[2].value()}; }
};

/// Returns the totals over all cells of a block except the halo and the parts `skipped`, which are sorted by
/// x.
FluidTotals block_totals(const Populations& populations, std::span<const Block> skipped = {});

/// Returns the sum of the totals of all ranks, on every rank. Collective.
FluidTotals sum_over_ranks(const FluidTotals& totals, const Communicator& communicator);

}  // namespace beadswim
