#pragma once

#include <vector>

#include "../lattice/fluid_box.hpp"
#include "beadswim/coupling/bead_boundary.hpp"
#include "beadswim/coupling/saturated_boundary.hpp"

namespace beadswim::test {

/// A sphere that is held in a periodic box of fluid (an infinite cubic array), at rest or rotating with a
/// given angular velocity.
class FixedSphere {
 public:
  FixedSphere(int edge, double radius, const Vec3& centre, double relaxation_time,
              BeadScheme scheme = BeadScheme::staircase)
      : fluid(Index3::Constant(edge), periodic, relaxation_time, MPI_COMM_SELF, Precision::fp64,
              halo_content(scheme)),
        coverage(BlockInLattice{.block = fluid.block, .cells = fluid.block.size, .boundary = periodic},
                 fluid.populations),
        links(scheme),
        cells(BlockInLattice{.block = fluid.block, .cells = fluid.block.size, .boundary = periodic}),
        beads{{.name = {}, .owner = 0, .radius = radius, .motion = {.position = centre}, .impulse = {}}} {
    coverage.update(beads);
    links.find(coverage);
    cells.find(beads);
  }

  /// Performs one time step and returns the mean over the volume of the fluid velocity outside the sphere in
  /// the middle of this step.
  Vec3 superficial_velocity() {
    const Vec3 sum = has_links(links.scheme()) ? sum_over_fluid_cells() : sum_over_parts_of_cells();
    return sum / fluid.populations.size().cast<double>().prod();
  }

  /// Performs one time step and returns the impulse and angular impulse that the fluid transfers to the
  /// sphere.
  Load step() {
    beads[0].impulse = {};
    fluid.halo.fill(fluid.populations);
    BeadBoundary boundary{coverage, links, beads, fluid.rates, sums};
    saturated_forces.clear();
    SaturatedBoundary saturated{cells,
                                beads,
                                saturated_sums,
                                saturated_forces,
                                fluid.body_force,
                                lattice_viscosity(1 / fluid.rates.symmetric)};
    for (int z = 0; z < fluid.populations.size()[2]; ++z) {
      for (int y = 0; y < fluid.populations.size()[1]; ++y) {
        if (has_links(links.scheme())) {
          if (y == 0) boundary.bounce_back_before_plane(fluid.populations, z);
        } else {
          saturated.apply_forces_before_row(fluid.populations, y, z);
        }
      }
    }
    stream_and_collide(fluid.populations, fluid.rates, fluid.halo.row_ends(), fluid.body_force);
    transfer_impulses(sums, beads);
    transfer_impulses(saturated_sums, beads);
    return beads[0].impulse.value();
  }

  static constexpr std::array<Boundary, 3> periodic{Boundary::periodic, Boundary::periodic,
                                                    Boundary::periodic};
  FluidBox fluid;
  Coverage coverage;
  BeadLinks links;
  SaturatedCells cells;
  std::vector<LinkSums> sums{1};
  std::vector<SaturatedSums> saturated_sums{1};
  std::vector<SaturatedForce> saturated_forces;
  std::vector<BeadOnLattice> beads;

 private:
  Vec3 sum_over_fluid_cells() {
    step();
    Vec3 sum = Vec3::Zero();
    for_each_cell(fluid.populations, [&](const Index3& p, std::ptrdiff_t) {
      if (!coverage.is_covered(p[0], p[1], p[2])) sum += fluid.velocity(p[0], p[1], p[2]);
    });
    return sum;
  }

  /// Sums the fluid velocity over the fluid parts of cells. The velocity of a cell is the mean of its momenta
  /// before and after the step.
  Vec3 sum_over_parts_of_cells() {
    const Populations& populations = fluid.populations;
    std::vector<double> fluid_part(populations.cell(populations.size()), 1);
    for_each_cell(populations, [&](const Index3& p, std::ptrdiff_t cell) {
      for (const SaturatedRun& run : cells.runs(p[1], p[2])) {
        if (run.contains(p[0])) fluid_part[cell] -= cells.fraction(run, p[0]);
      }
    });
    Vec3 sum = Vec3::Zero();
    fluid.halo.fill(fluid.populations);
    for_each_cell(populations, [&](const Index3&, std::ptrdiff_t cell) {
      for (int i = 1; i < d3q19::directions; ++i) {
        const auto& c = d3q19::velocity[i];
        sum += 0.5 * fluid_part[cell] * populations.incoming(i, cell) * Vec3(c[0], c[1], c[2]);
      }
    });
    step();
    for_each_cell(populations, [&](const Index3&, std::ptrdiff_t cell) {
      sum += 0.5 * fluid_part[cell] * cell_moments(populations, cell).momentum;
    });
    return sum;
  }
};

}  // namespace beadswim::test
