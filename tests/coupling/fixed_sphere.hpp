#pragma once

#include <vector>

#include "../lattice/fluid_box.hpp"
#include "beadswim/coupling/bead_boundary.hpp"

namespace beadswim::test {

/// One sphere held in a periodic box of fluid, at rest or turning at a given rate: an infinite cubic array.
class FixedSphere {
 public:
  FixedSphere(int edge, double radius, const Vec3& centre, double relaxation_time)
      : fluid(Index3::Constant(edge), periodic, relaxation_time),
        coverage(block_in_lattice(fluid.decomposition, 0, periodic), fluid.populations),
        beads{{.name = {}, .owner = 0, .radius = radius, .motion = {.position = centre}, .impulse = {}}} {
    coverage.update(beads);
  }

  /// One step; returns the impulse that the fluid hands to the sphere.
  Load step() {
    beads[0].impulse = {};
    fluid.halo.fill(fluid.populations);
    bounce_back_at_beads(fluid.populations, coverage, beads);
    stream_and_collide(fluid.populations, fluid.rates);
    fluid.add_body_force();
    reset_covered_cells(fluid.populations, coverage, beads);
    return beads[0].impulse.value();
  }

  static constexpr std::array<Wall, 3> periodic{Wall::periodic, Wall::periodic, Wall::periodic};
  FluidBox fluid;
  Coverage coverage;
  std::vector<BeadOnLattice> beads;
};

}  // namespace beadswim::test
