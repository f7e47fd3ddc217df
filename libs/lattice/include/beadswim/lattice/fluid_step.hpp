#pragma once

#include "beadswim/lattice/halo.hpp"
#include "beadswim/lattice/populations.hpp"
#include "beadswim/lattice/sweep.hpp"
#include "beadswim/lattice/trt.hpp"

namespace beadswim {

/// Returns the coordinate z of the plane that a step sweeps as number n: 2, 3, ..., planes - 1, 0, 1. The two
/// outermost planes on each side come last, because only their rows, and bead links next to these rows, read
/// the halo across z. Messages for this halo may be in transit while the other planes are swept.
constexpr int plane_in_order(int n, int planes) {
  return (n + 2) % planes;
}
/// Inverse of plane_in_order(): returns the number n of the plane at z.
constexpr int order_of_plane(int z, int planes) {
  return (z + 2 * planes - 2) % planes;
}
/// Returns the number n of the first plane that needs the complete halo.
constexpr int first_outer_plane(int planes) {
  return planes > 4 ? planes - 4 : 0;
}

/// Advances the fluid of a block by one time step. Calls before_row(y, z) before it sweeps the row (y, z). At
/// this time the halo cells that the row reads are filled. before_row must apply the boundary condition on
/// the links between this row and rows that have not been swept yet.
template <class BeforeRow>
void step_fluid(Populations& populations, Halo& halo, const RelaxationRates& rates, BeforeRow&& before_row) {
  halo.start(populations);
  BlockSweep sweep(populations, rates, halo.row_ends());
  const int rows = populations.size()[1], planes = populations.size()[2];
  for (int n = 0; n < planes; ++n) {
    if (n < first_outer_plane(planes)) halo.progress();
    if (n == first_outer_plane(planes)) halo.finish(populations);
    const int z = plane_in_order(n, planes);
    for (int y = 0; y < rows; ++y) {
      before_row(y, z);
      sweep.row(y, z);
    }
  }
  sweep.finish();
}

inline void step_fluid(Populations& populations, Halo& halo, const RelaxationRates& rates) {
  step_fluid(populations, halo, rates, [](int, int) {});
}

}  // namespace beadswim
