#include "beadswim/coupling/bead_boundary.hpp"

#include <algorithm>

#include "add_one_by_one.hpp"
#include "beadswim/coupling/fault.hpp"
#include "beadswim/coupling/moving_bounce_back.hpp"
#include "beadswim/coupling/multireflection.hpp"
#include "beadswim/coupling/refill.hpp"
#include "link_kernel.hpp"

namespace beadswim {
namespace {

/// Returns the data of a bead that the link kernel needs.
LinkBead link_bead(const BeadOnLattice& bead, double slip = 0) {
  const Vec3 &v = bead.motion.velocity, &omega = bead.motion.angular_velocity;
  return {.velocity = {v[0], v[1], v[2]},
          .angular_velocity = {omega[0], omega[1], omega[2]},
          .mass_source = bead.mass_source,
          .radius = bead.radius,
          .slip = slip};
}

/// Fills the unused entries of the last vector of the batch with zeros, so that they contribute nothing to
/// sums. The direction is (1, 0, 0), so that no division by zero occurs.
void fill_lanes(LinkBatch& batch) {
  for (int k = batch.links; k % LinkSums::lanes != 0; ++k) {
    for (double* values :
         {batch.x, batch.y, batch.z, batch.cy, batch.cz, batch.weight, batch.outgoing, batch.fluid_behind,
          batch.behind, batch.arrived, batch.two_behind, batch.arrived_behind, batch.speed})
      values[k] = 0;
    batch.cx[k] = 1;
  }
}

/// For one direction i: all directions j with c_i.c_j != 0, and the values c_i.c_j.
struct Projections {
  int count = 0;
  std::array<int, 14> direction{};
  std::array<double, 14> value{};
};
constexpr auto projections_on_directions = [] {
  std::array<Projections, d3q19::directions> table{};
  for (int i = 0; i < d3q19::directions; ++i) {
    for (int j = 0; j < d3q19::directions; ++j) {
      const auto &a = d3q19::velocity[i], &b = d3q19::velocity[j];
      const int value = a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
      if (value == 0) continue;
      Projections& projections = table[i];
      projections.direction[projections.count] = j;
      projections.value[projections.count++] = value;
    }
  }
  return table;
}();

/// Collects links of one image of a bead in batches and passes the batches to the link kernel.
template <class Real>
class LinkReflection {
 public:
  LinkReflection(BeadBoundary& boundary, Populations& populations)
      : boundary_(boundary), populations_(populations) {}

  void add(std::span<BeadLink> links, const CoveredImage& covered) {
    if (covered_ != &covered) flush();
    covered_ = &covered;
    for (BeadLink& link : links) {
      if (batch_.links == LinkBatch::max_links) flush();
      add(link);
    }
  }

  /// Reflects the populations at all links that were added since the last call.
  void flush() {
    if (batch_.links == 0) return;
    fetch();
    fill_lanes(batch_);
    LinkSums& sums = boundary_.sums[covered_->bead];
    sums.reserve_terms(LinkBatch::max_links / LinkSums::lanes);
    const LinkBead bead = link_bead(boundary_.beads[covered_->bead], slip_);
    if (!link_kernels().reflect<Real>(boundary_.links.scheme(), batch_, bead, sums))
      add_one_by_one(batch_, batch_.links, sums, boundary_.beads[covered_->bead]);
    for (int k = 0; k < batch_.links; ++k) *incoming_[k] = static_cast<Real>(batch_.returned[k]);
    batch_.links = 0;
  }

 private:
  void add(BeadLink& link) {
    const Index3& low = covered_->image.low;
    const int x = low[0] + link.from_low[0], y = low[1] + link.from_low[1], z = low[2] + link.from_low[2];
    const int out = link.out, in = d3q19::opposite(out);
    const std::ptrdiff_t fluid_cell = boundary_.coverage.cell(x, y, z) + populations_.shift(out);
    const Real* outgoing = populations_.outgoing_row<Real>(in, fluid_cell);
    if (!link.fluid_is_own) {  // the rank that owns the fluid cell reflects
      link.outgoing = static_cast<double>(*outgoing);
      return;
    }
    const int k = batch_.links++;
    links_[k] = &link;
    outgoing_[k] = outgoing;
    incoming_[k] = populations_.incoming_row<Real>(out, fluid_cell);
    const Vec3 from_centre = covered_->from_centre(x, y, z);
    batch_.x[k] = from_centre[0], batch_.y[k] = from_centre[1], batch_.z[k] = from_centre[2];
    const auto& c = d3q19::velocity[out];
    batch_.cx[k] = c[0], batch_.cy[k] = c[1], batch_.cz[k] = c[2];
    batch_.weight[k] = d3q19::weight(out);
    if (cells_behind_ == 0) return;
    batch_.fluid_behind[k] = link.fluid_behind;
    const std::ptrdiff_t behind =
        link.fluid_behind > 0
            ? boundary_.coverage.wrapped_along_x(fluid_cell + populations_.shift(out), x + 2 * c[0])
            : fluid_cell;
    behind_[k] = populations_.outgoing_row<Real>(in, behind);
    arrived_[k] = populations_.outgoing_row<Real>(out, fluid_cell);
    if (cells_behind_ == 1) return;
    two_behind_[k] = link.fluid_behind > 1 ? populations_.incoming_row<Real>(in, behind) : outgoing;
    arrived_behind_[k] = populations_.outgoing_row<Real>(out, behind);
    batch_.speed[k] = link.fluid_behind > 1 ? momentum_along(in, fluid_cell) : 0;
  }

  /// Returns c_i.u, where u is the momentum of the cell.
  double momentum_along(int i, std::ptrdiff_t cell) const {
    const Projections& projections = projections_on_directions[i];
    double sum = 0;
    for (int n = 0; n < projections.count; ++n)
      sum += projections.value[n] *
             static_cast<double>(*populations_.outgoing_row<Real>(projections.direction[n], cell));
    return sum;
  }

  /// Reads the populations that the links need. One short loop per array allows many memory accesses at the
  /// same time.
  void fetch() {
    for (int k = 0; k < batch_.links; ++k) batch_.outgoing[k] = static_cast<double>(*outgoing_[k]);
    if (cells_behind_ >= 1) {
      for (int k = 0; k < batch_.links; ++k) batch_.behind[k] = static_cast<double>(*behind_[k]);
      for (int k = 0; k < batch_.links; ++k) batch_.arrived[k] = static_cast<double>(*arrived_[k]);
    }
    if (cells_behind_ >= 2) {
      for (int k = 0; k < batch_.links; ++k) batch_.two_behind[k] = static_cast<double>(*two_behind_[k]);
      for (int k = 0; k < batch_.links; ++k)
        batch_.arrived_behind[k] = static_cast<double>(*arrived_behind_[k]);
    }
    for (int k = 0; k < batch_.links; ++k) links_[k]->outgoing = batch_.outgoing[k];
  }

  BeadBoundary& boundary_;
  Populations& populations_;
  const int cells_behind_ = cells_behind(boundary_.links.scheme());
  const double slip_ = multireflection_slip(boundary_.rates);
  const CoveredImage* covered_ = nullptr;
  LinkBatch batch_;
  std::array<BeadLink*, LinkBatch::max_links> links_;
  std::array<Real*, LinkBatch::max_links> incoming_;
  std::array<const Real*, LinkBatch::max_links> outgoing_, behind_, arrived_, two_behind_, arrived_behind_;
};

/// Refills an uncovered cell (refill.hpp) from the populations that streamed into it along the links that
/// ended in it.
void refill(Populations& populations, const ChangedCell& cell, const BeadLinks& links,
            const BeadOnLattice& bead, const RelaxationRates& rates) {
  const LinkBead b = link_bead(bead);
  const double r[3] = {cell.from_centre[0], cell.from_centre[1], cell.from_centre[2]};
  Arrivals arrivals;
  double sum = 0, weights = 0;
  links.for_each_link_of(cell.image, cell.local[0], cell.local[1], cell.local[2], [&](const BeadLink& link) {
    const int in = d3q19::opposite(link.out);
    const auto& to = d3q19::velocity[in];
    const double c[3] = {double(to[0]), double(to[1]), double(to[2])}, weight = d3q19::weight(in);
    arrivals.population[in] = link.outgoing;
    arrivals.is_known[in] = true;
    sum +=
        weighted_density_deviation(weight, link.outgoing, speed_along(c, b.velocity, b.angular_velocity, r));
    weights += weight;
  });
  const double density_deviation = weights > 0 ? sum / weights : 0;
  const Vec3 velocity = bead.velocity_at(cell.from_centre);
  const Eigen::Matrix3d stress = stress_of(arrivals, density_deviation, velocity);
  for (int i = 0; i < d3q19::directions; ++i) {
    populations.set_outgoing(i, cell.cell,
                             refilled(i, density_deviation, velocity, stress, 1 - rates.symmetric));
  }
}

}  // namespace

void BeadBoundary::bounce_back_before_row(Populations& populations, int y, int z) {
  const int first = links.first_segment_of(y, z), end = links.end_segment_of(y, z);
  if (first == end) return;
  in_precision(populations.precision(), [&]<class Real>() {
    LinkReflection<Real> bounce(*this, populations);
    for (const LinkSegment& segment : links.segments().subspan(first, end - first)) {
      bounce.add(links.links(segment), coverage.images().images[segment.image]);
    }
    bounce.flush();
  });
}

void transfer_impulses(std::span<LinkSums> sums, std::span<BeadOnLattice> beads) {
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

void transfer_changed_cells(Populations& populations, const Coverage& coverage, const BeadLinks& links_before,
                            std::span<const BeadOnLattice> beads_before, std::span<BeadOnLattice> beads,
                            const RelaxationRates& rates) {
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
      throw not_finite_at(before);  // the bead moved by more than one cell in one step
    }
    refill(populations, uncovered, links_before, before, rates);
    const CellMoments fluid =
        cell_moments(populations, uncovered.cell);  // values as stored in the precision of the populations
    bead->impulse.add(-fluid.momentum, uncovered.from_centre);
    bead->impulse.mass.add(-fluid.density_deviation);
  }
}

}  // namespace beadswim
