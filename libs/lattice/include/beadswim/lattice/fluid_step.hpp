#pragma once

#include "beadswim/lattice/halo.hpp"
#include "beadswim/lattice/populations.hpp"
#include "beadswim/lattice/sweep.hpp"
#include "beadswim/lattice/trt.hpp"

namespace beadswim {

/// Returns the coordinate z of the plane that a time step sweeps as number n = 0, 1, ... `planes` is the
/// number of planes of constant z in the block. The order of z is 2, 3, ..., planes - 1, 0, 1, so that the
/// two outermost planes on each side come last. Only the rows of these four planes, and bead links next to
/// these rows, read the halo beyond the faces perpendicular to z. The messages that fill this halo may
/// therefore be in transit while the other planes are swept.
constexpr int plane_in_order(int n, int planes) {
  return (n + 2) % planes;
}
/// Inverse of plane_in_order(): returns the number n of the plane at z.
constexpr int order_of_plane(int z, int planes) {
  return (z + 2 * planes - 2) % planes;
}
/// Returns the number n, in the order of plane_in_order(), of the first plane whose sweep needs the complete
/// halo. All planes before it can be swept while messages along z are in transit.
constexpr int first_outer_plane(int planes) {
  return planes > 4 ? planes - 4 : 0;
}

/// Advances the fluid of a block by one time step: fills the halo, then streams and collides the populations
/// row by row. Calls before_row(y, z) before it sweeps the row (y, z). At this call, the halo cells that the
/// row reads are filled. before_row must apply the boundary condition on the links of this row (links end at
/// a bead) that have not been processed yet: links within the row, and links between the row and rows that
/// have not been swept. Calls before_plane(z) and after_plane(z) before and after it sweeps all rows of a
/// plane. body_force: momentum that each cell gains in this step (body_force.hpp). `skipped`: cells that the
/// step leaves as they are (BlockSweep).
template <class BeforePlane, class BeforeRow, class AfterPlane>
void step_fluid(Populations& populations, Halo& halo, const RelaxationRates& rates, const Vec3& body_force,
                BeforePlane&& before_plane, BeforeRow&& before_row, AfterPlane&& after_plane,
                std::span<const Block> skipped = {}) {
  halo.start(populations);
  BlockSweep sweep(populations, rates, halo.row_ends(), body_force, skipped);
  const int rows = populations.size()[1], planes = populations.size()[2];
  for (int n = 0; n < planes; ++n) {
    if (n < first_outer_plane(planes)) halo.progress();
    if (n == first_outer_plane(planes)) halo.finish(populations);
    const int z = plane_in_order(n, planes);
    before_plane(z);
    for (int y = 0; y < rows; ++y) {
      before_row(y, z);
      sweep.row(y, z);
    }
    after_plane(z);
  }
  sweep.finish();
}

inline void step_fluid(Populations& populations, Halo& halo, const RelaxationRates& rates,
                       const Vec3& body_force = Vec3::Zero()) {
  step_fluid(
      populations, halo, rates, body_force, [](int) {}, [](int, int) {}, [](int) {});
}

}  // namespace beadswim
