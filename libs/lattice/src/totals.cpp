#include "beadswim/lattice/totals.hpp"

#include <algorithm>
#include <type_traits>

#include "beadswim/core/kernel_choice.hpp"
#include "beadswim/core/order_free_cut.hpp"
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

namespace {

/// Adds density deviation and momentum of `cells` consecutive cells of a row, beginning with cell `first`, to
/// `totals`.
template <class Real>
void add_run(FluidTotals& totals, const Populations& populations, std::ptrdiff_t first, long cells) {
  TotalsRow<Real> row{.outgoing = {}, .cells = cells};
  for (int i = 0; i < d3q19::directions; ++i) row.outgoing[i] = populations.outgoing_row<Real>(i, first);
  const RowTotals sums = best_kernels<RowKernels>().totals(row);
  if (!sums.fits) {  // OrderFreeSum accepts larger terms, and throws if a term exceeds its range
    for (long x = 0; x < cells; ++x) totals.add(cell_moments(populations, first + x));
    return;
  }
  totals.density_deviation.add_split(sums.coarse[0], sums.fine[0]);
  for (int a = 0; a < 3; ++a) totals.momentum[a].add_split(sums.coarse[a + 1], sums.fine[a + 1]);
}

}  // namespace

FluidTotals block_totals(const Populations& populations, std::span<const Block> skipped) {
  constexpr int longest_run = order_free::max_terms;
  FluidTotals totals;
  const Index3& n = populations.size();
  in_precision(populations.precision(), [&]<class Real>() {
    for (int z = 0; z < n[2]; ++z) {
      for (int y = 0; y < n[1]; ++y) {
        for_each_run_outside(skipped, n[0], y, z, [&](int first, int end) {
          for (int x = first; x < end; x += longest_run)
            add_run<Real>(totals, populations, populations.cell(x, y, z), std::min(longest_run, end - x));
        });
      }
    }
  });
  return totals;
}

FluidTotals sum_over_ranks(const FluidTotals& totals, const Communicator& communicator) {
  static_assert(std::is_trivially_copyable_v<FluidTotals> && sizeof(FluidTotals) == 8 * sizeof(std::int64_t));
  FluidTotals sum = totals;
  MPI_Allreduce(MPI_IN_PLACE, &sum, 8, MPI_INT64_T, MPI_SUM, communicator.get());
  return sum;
}

}  // namespace beadswim
