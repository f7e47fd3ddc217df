#pragma once

#include <array>

#include "beadswim/core/communicator.hpp"
#include "beadswim/core/order_free_sum.hpp"
#include "beadswim/lattice/populations.hpp"

namespace beadswim {

/// Mass and momentum of a set of cells, the same bits for every decomposition of the set.
struct FluidTotals {
  OrderFreeSum density_deviation;        ///< sum of (density - 1)
  std::array<OrderFreeSum, 3> momentum;  ///< sum of c_i f_i

  /// Throws SolverError if a moment is not finite.
  void add(const CellMoments& moments);
  void add(const FluidTotals& other);
  void subtract(const FluidTotals& other);

  Vec3 momentum_value() const { return {momentum[0].value(), momentum[1].value(), momentum[2].value()}; }
};

/// Totals over all own cells of a block.
FluidTotals block_totals(const Populations& populations);

/// Adds up the ranks' totals; every rank gets the sum.
FluidTotals sum_over_ranks(const FluidTotals& totals, const Communicator& communicator);

}  // namespace beadswim
