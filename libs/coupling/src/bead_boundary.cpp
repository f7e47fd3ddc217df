#include "beadswim/coupling/bead_boundary.hpp"

#include <algorithm>

#include "beadswim/core/error.hpp"
#include "beadswim/coupling/moving_bounce_back.hpp"

namespace beadswim {

namespace {

/// The links between one covered cell and the fluid around it.
void bounce_back_around(CoveredCell& covered, Populations& populations, const Coverage& coverage,
                        BeadOnLattice& bead) {
  const bool own = coverage.is_own(covered.local);
  double density_sum = 0, weight_sum = 0;
  for (int out = 1; out < d3q19::directions; ++out) {  // from the covered cell into the fluid
    const std::ptrdiff_t neighbour = covered.cell + populations.shift(out);
    const auto& c = d3q19::velocity[out];
    const Index3 local = covered.local + Index3(c[0], c[1], c[2]);
    if (!coverage.is_in_halo_or_own(local) || coverage.bead_at(neighbour) != Coverage::fluid) continue;
    const bool own_neighbour = coverage.is_own(local);
    if (!own && !own_neighbour) continue;

    const int in = d3q19::opposite(out);
    const double weight = d3q19::weight(in);
    const Vec3 link_centre = covered.from_centre + 0.5 * Vec3(c[0], c[1], c[2]);
    const Vec3 wall_velocity = bead.velocity_at(link_centre);
    const double outgoing = populations.outgoing(in, neighbour);
    density_sum += weighted_density_deviation(in, outgoing, wall_velocity);
    weight_sum += weight;
    if (!own_neighbour) continue;  // its owner's link
    const double returned = bounced(in, outgoing, wall_velocity) + weight * bead.mass_source;
    populations.incoming(out, neighbour) = returned;
    bead.impulse.add(link_impulse(in, outgoing, returned), link_centre);
    bead.impulse.mass.add(outgoing - returned);
    bead.impulse.link_weight.add(weight);
  }
  covered.density_deviation = weight_sum > 0 ? density_sum / weight_sum : 0;
}

}  // namespace

void bounce_back_at_beads(Populations& populations, Coverage& coverage, std::span<BeadOnLattice> beads) {
  for (CoveredCell& covered : coverage.cells()) {
    bounce_back_around(covered, populations, coverage, beads[covered.bead]);
  }
}

void reset_covered_cells(Populations& populations, const Coverage& coverage,
                         std::span<const BeadOnLattice> beads) {
  for (const CoveredCell& covered : coverage.cells()) {
    if (!coverage.is_own(covered.local)) continue;
    set_equilibrium(populations, covered.cell, covered.density_deviation,
                    beads[covered.bead].velocity_at(covered.from_centre));
  }
}

void hand_over_changed_cells(const Populations& populations, const Coverage& before,
                             std::span<const BeadOnLattice> before_beads, const Coverage& now,
                             std::span<BeadOnLattice> beads) {
  for (const CoveredCell& covered : now.cells()) {
    if (!now.is_own(covered.local) || before.bead_at(covered.cell) != Coverage::fluid) continue;
    const CellMoments fluid = cell_moments(populations, covered.cell);
    Impulse& impulse = beads[covered.bead].impulse;
    impulse.add(fluid.momentum, covered.from_centre);
    impulse.mass.add(fluid.density_deviation);
  }
  for (const CoveredCell& uncovered : before.cells()) {
    if (!before.is_own(uncovered.local) || now.bead_at(uncovered.cell) != Coverage::fluid) continue;
    const BeadName name = before_beads[uncovered.bead].name;
    const auto bead = std::ranges::lower_bound(beads, name, {}, &BeadOnLattice::name);
    if (bead == beads.end() || bead->name != name) {
      throw SolverError("a bead moved farther than a cell in one step");
    }
    const CellMoments fluid = cell_moments(populations, uncovered.cell);
    bead->impulse.add(-fluid.momentum, uncovered.from_centre);
    bead->impulse.mass.add(-fluid.density_deviation);
  }
}

}  // namespace beadswim
