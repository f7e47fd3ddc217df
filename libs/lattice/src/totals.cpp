#include "beadswim/lattice/totals.hpp"

#include <algorithm>
#include <type_traits>

#include "beadswim/core/kernel.hpp"
#include "row_kernels.hpp"

namespace beadswim {

void FluidTotals::add(const CellMoments& moments) {
  density_deviation.add(moments.density_deviation);
  for (int a = 0; a < 3; ++a) momentum[a].add(moments.momentum[a]);
}

void FluidTotals::add(const FluidTotals& other) {
  density_deviation.add(other.density_deviation);
  for (int a = 0; a < 3; ++a) momentum[a].add(other.momentum[a]);
}

void FluidTotals::subtract(const FluidTotals& other) {
  density_deviation.subtract(other.density_deviation);
  for (int a = 0; a < 3; ++a) momentum[a].subtract(other.momentum[a]);
}

FluidTotals block_totals(const Populations& populations, std::span<const Block> skipped) {
  FluidTotals totals;
  OrderFreeLanes<4> sums;
  const Index3& n = populations.size();
  in_precision(populations.precision(), [&]<class Real>() {
    constexpr int max_cells = TotalsRow<Real>::max_cells;
    const auto add_run = [&](std::ptrdiff_t first, int cells) {
      TotalsRow<Real> row{.outgoing = {}, .cells = cells};
      for (int i = 0; i < d3q19::directions; ++i) row.outgoing[i] = populations.outgoing_row<Real>(i, first);
      sums.reserve_terms(max_cells / lanes);
      if (best_kernels<RowKernels>().add_totals(row, sums)) return;
      // FluidTotals accepts larger terms, and throws if a term exceeds its range.
      for (int x = 0; x < cells; ++x) totals.add(cell_moments(populations, first + x));
    };
    for (int z = 0; z < n[2]; ++z) {
      for (int y = 0; y < n[1]; ++y) {
        for_each_run_outside(skipped, n[0], y, z, [&](int first, int end) {
          for (int x = first; x < end; x += max_cells)
            add_run(populations.cell(x, y, z), std::min(max_cells, end - x));
        });
      }
    }
  });
  const std::array<OrderFreeSum, 4> sum = sums.take();
  totals.add({.density_deviation = sum[0], .momentum = {sum[1], sum[2], sum[3]}});
  return totals;
}

FluidTotals sum_over_ranks(const FluidTotals& totals, const Communicator& communicator) {
  static_assert(std::is_trivially_copyable_v<FluidTotals> && sizeof(FluidTotals) == 8 * sizeof(std::int64_t));
  FluidTotals sum = totals;
  MPI_Allreduce(MPI_IN_PLACE, &sum, 8, MPI_INT64_T, MPI_SUM, communicator.get());
  return sum;
}

}  // namespace beadswim
