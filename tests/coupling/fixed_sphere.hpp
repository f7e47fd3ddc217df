#pragma once

#include <vector>

#include "../lattice/fluid_box.hpp"
#include "beadswim/coupling/bead_boundary.hpp"

namespace beadswim::test {

/// One sphere held in a periodic box of fluid, at rest or turning at a given rate: an infinite cubic array.
class FixedSphere {
 public:
  FixedSphere(int edge, double radius, const Vec3& centre, double relaxation_time,
              LinkScheme scheme = LinkScheme::staircase)
      : fluid(Index3::Constant(edge), periodic, relaxation_time, MPI_COMM_SELF, Precision::fp64,
              halo_content(scheme)),
        coverage(block_in_lattice(fluid.decomposition, 0, periodic), fluid.populations),
        links(scheme),
        beads{{.name = {}, .owner = 0, .radius = radius, .motion = {.position = centre}, .impulse = {}}} {
    coverage.update(beads);
    links.find(coverage);
  }

  /// One step; returns the impulse that the fluid hands to the sphere.
  Load step() {
    beads[0].impulse = {};
    fluid.halo.fill(fluid.populations);
    BeadBoundary boundary{coverage, links, beads, fluid.rates, sums};
    for (int z = 0; z < fluid.populations.size()[2]; ++z) {
      for (int y = 0; y < fluid.populations.size()[1]; ++y) {
        boundary.bounce_back_before_row(fluid.populations, y, z);
      }
    }
    stream_and_collide(fluid.populations, fluid.rates, fluid.halo.row_ends());
    hand_over_impulses(sums, beads);
    fluid.add_body_force();
    return beads[0].impulse.value();
  }

  static constexpr std::array<Wall, 3> periodic{Wall::periodic, Wall::periodic, Wall::periodic};
  FluidBox fluid;
  Coverage coverage;
  BeadLinks links;
  std::vector<LinkSums> sums{1};
  std::vector<BeadOnLattice> beads;
};

}  // namespace beadswim::test
