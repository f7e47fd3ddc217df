#include "beadswim/lattice/totals.hpp"

#include <type_traits>

namespace beadswim {

void FluidTotals::add(const CellMoments& moments) {
  density_deviation.add(moments.density_deviation);
  for (int a = 0; a < 3; ++a) momentum[a].add(moments.momentum[a]);
}

void FluidTotals::add(const FluidTotals& other) {
  density_deviation.add(other.density_deviation);
  for (int a = 0; a < 3; ++a) momentum[a].add(other.momentum[a]);
}

FluidTotals block_totals(const Populations& populations) {
  FluidTotals totals;
  for_each_cell(populations,
                [&](const Index3&, std::ptrdiff_t cell) { totals.add(cell_moments(populations, cell)); });
  return totals;
}

FluidTotals sum_over_ranks(const FluidTotals& totals, const Communicator& communicator) {
  static_assert(std::is_trivially_copyable_v<FluidTotals> && sizeof(FluidTotals) == 8 * sizeof(std::int64_t));
  FluidTotals sum = totals;
  MPI_Allreduce(MPI_IN_PLACE, &sum, 8, MPI_INT64_T, MPI_SUM, communicator.get());
  return sum;
}

}  // namespace beadswim
