#pragma once

#include "beadswim/lattice/halo.hpp"
#include "beadswim/lattice/populations.hpp"
#include "beadswim/lattice/sweep.hpp"
#include "beadswim/lattice/trt.hpp"

namespace beadswim {

/// The order in which a step comes to the planes of a block across z: 2, 3, ..., planes - 1, 0, 1. Messages
/// for the halo may be under way until the outermost two on either side: rows of these, or links of beads
/// next to them, read it.
constexpr int plane_in_order(int n, int planes) {
  return (n + 2) % planes;
}
constexpr int place_in_order(int z, int planes) {
  return (z + 2 * planes - 2) % planes;
}
/// The place in this order from which on all of the halo is filled.
constexpr int first_outer_plane(int planes) {
  return planes > 4 ? planes - 4 : 0;
}

/// One step of the fluid in a block. Calls before_row(y, z) before each row is swept, with the halo filled
/// that the row reads: there, bounce back along links between this row and rows not yet swept.
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
