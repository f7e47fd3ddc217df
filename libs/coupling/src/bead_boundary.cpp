#include "beadswim/coupling/bead_boundary.hpp"

#include <algorithm>

#include "beadswim/core/error.hpp"
#include "beadswim/coupling/moving_bounce_back.hpp"
#include "link_kernel.hpp"

namespace beadswim {
namespace {

LinkBead link_bead(const BeadOnLattice& bead) {
  const Vec3 &v = bead.motion.velocity, &omega = bead.motion.angular_velocity;
  return {.velocity = {v[0], v[1], v[2]},
          .angular_velocity = {omega[0], omega[1], omega[2]},
          .mass_source = bead.mass_source};
}

/// Puts a link into the batch.
void put(LinkBatch& batch, const BeadLink& link, const Vec3& from_centre) {
  const int k = batch.links++;
  const auto& c = d3q19::velocity[link.out];
  batch.x[k] = from_centre[0], batch.y[k] = from_centre[1], batch.z[k] = from_centre[2];
  batch.cx[k] = c[0], batch.cy[k] = c[1], batch.cz[k] = c[2];
  batch.weight[k] = d3q19::weight(link.out);
  batch.outgoing[k] = link.outgoing;
}

/// Zeros after the last link, up to whole lanes.
void fill_lanes(LinkBatch& batch) {
  for (int k = batch.links; k % LinkSums::lanes != 0; ++k) {
    for (double* values :
         {batch.x, batch.y, batch.z, batch.cx, batch.cy, batch.cz, batch.weight, batch.outgoing})
      values[k] = 0;
  }
}

/// Terms too large for lanes, one by one: there is more room there, and a message if it does not suffice.
void add_one_by_one(const LinkBatch& batch, LinkSums& sums) {
  for (int t = 0; t < link_terms; ++t) {
    for (int k = 0; k < batch.links; ++k) sums.sums[t].add(batch.terms[t][k]);
  }
}

/// Bounces back along up to LinkBatch::most links of one bead.
template <class Real>
void bounce_back(std::span<BeadLink> links, const CoveredImage& covered, const BeadBoundary& boundary,
                 Populations& populations) {
  const Index3& low = covered.image.low;
  LinkBatch batch;
  std::array<Real*, LinkBatch::most> incoming;
  for (BeadLink& link : links) {
    const int x = low[0] + link.from_low[0], y = low[1] + link.from_low[1], z = low[2] + link.from_low[2];
    const std::ptrdiff_t fluid_cell = boundary.coverage.cell(x, y, z) + populations.shift(link.out);
    link.outgoing =
        static_cast<double>(*populations.outgoing_row<Real>(d3q19::opposite(link.out), fluid_cell));
    if (!link.fluid_is_own) continue;  // its owner's link
    incoming[batch.links] = populations.incoming_row<Real>(link.out, fluid_cell);
    put(batch, link, covered.from_centre(x, y, z));
  }
  if (batch.links == 0) return;
  fill_lanes(batch);
  LinkSums& sums = boundary.sums[covered.bead];
  sums.make_room(LinkBatch::most / LinkSums::lanes);
  if (!link_kernels().reflect<Real>(batch, link_bead(boundary.beads[covered.bead]), sums))
    add_one_by_one(batch, sums);
  for (int k = 0; k < batch.links; ++k) *incoming[k] = static_cast<Real>(batch.returned[k]);
}

/// Mean density deviation of the fluid around a cell that was covered, over its links.
double density_around(const ChangedCell& cell, const BeadLinks& links, const BeadOnLattice& bead) {
  const LinkBead b = link_bead(bead);
  const double r[3] = {cell.from_centre[0], cell.from_centre[1], cell.from_centre[2]};
  double sum = 0, weights = 0;
  links.for_each_link_of(cell.image, cell.local[0], cell.local[1], cell.local[2], [&](const BeadLink& link) {
    const auto& in = d3q19::velocity[d3q19::opposite(link.out)];
    const double c[3] = {double(in[0]), double(in[1]), double(in[2])}, weight = d3q19::weight(link.out);
    sum +=
        weighted_density_deviation(weight, link.outgoing, speed_along(c, b.velocity, b.angular_velocity, r));
    weights += weight;
  });
  return weights > 0 ? sum / weights : 0;
}

}  // namespace

void BeadBoundary::bounce_back_before_row(Populations& populations, int y, int z) {
  const std::span<const LinkSegment> segments = links.segments();
  const int end = links.end_segment_of(y, z);
  for (int s = links.first_segment_of(y, z); s < end; ++s) {
    std::span<BeadLink> rest = links.links(segments[s]);
    while (!rest.empty()) {
      const std::size_t now = std::min<std::size_t>(rest.size(), LinkBatch::most);
      const CoveredImage& covered = coverage.images().images[segments[s].image];
      in_precision(populations.precision(),
                   [&]<class Real>() { bounce_back<Real>(rest.first(now), covered, *this, populations); });
      rest = rest.subspan(now);
    }
  }
}

void hand_over_impulses(std::span<LinkSums> sums, std::span<BeadOnLattice> beads) {
  for (std::size_t b = 0; b < beads.size(); ++b) {
    const std::array<OrderFreeSum, link_terms> total = sums[b].take();
    Impulse& impulse = beads[b].impulse;
    for (int a = 0; a < 3; ++a) {
      impulse.linear[a].add(total[a]);
      impulse.angular[a].add(total[3 + a]);
    }
    impulse.mass.add(total[6]);
    impulse.link_weight.add(total[7]);
  }
}

void hand_over_changed_cells(Populations& populations, const Coverage& coverage,
                             const BeadLinks& links_before, std::span<const BeadOnLattice> beads_before,
                             std::span<BeadOnLattice> beads) {
  for (const ChangedCell& covered : coverage.newly_covered()) {
    const CellMoments fluid = cell_moments(populations, covered.cell);
    Impulse& impulse = beads[covered.bead].impulse;
    impulse.add(fluid.momentum, covered.from_centre);
    impulse.mass.add(fluid.density_deviation);
  }
  for (const ChangedCell& uncovered : coverage.uncovered()) {
    const BeadOnLattice& before = beads_before[uncovered.bead];
    const auto bead = std::ranges::lower_bound(beads, before.name, {}, &BeadOnLattice::name);
    if (bead == beads.end() || bead->name != before.name) {
      throw SolverError("a bead moved farther than a cell in one step");
    }
    set_equilibrium(populations, uncovered.cell, density_around(uncovered, links_before, before),
                    before.velocity_at(uncovered.from_centre));
    const CellMoments fluid = cell_moments(populations, uncovered.cell);  // as stored
    bead->impulse.add(-fluid.momentum, uncovered.from_centre);
    bead->impulse.mass.add(-fluid.density_deviation);
  }
}

}  // namespace beadswim
