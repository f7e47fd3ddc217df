#include <algorithm>

#include "bead_kernels.hpp"
#include "beadswim/core/kernel.hpp"
#include "beadswim/coupling/bead_links.hpp"
#include "beadswim/coupling/fault.hpp"
#include "beadswim/coupling/link_laws.hpp"
#include "beadswim/coupling/refill.hpp"
#include "beadswim/lattice/d3q19.hpp"

namespace beadswim {
namespace {

/// Returns the data of a bead that the link kernel needs.
KernelBead link_bead(const BeadOnLattice& bead, double slip = 0) {
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

/// Prefetches to the second level of the cache. The first level can wait for few lines at a time.
inline void prefetch(const void* address) {
  __builtin_prefetch(address, 0, 2);
}

/// Links of one image of a bead that are reflected together, and the addresses of their populations.
template <class Real>
struct AddressedLinks {
  template <class Value>
  using PerLink = std::array<Value, LinkBatch::max_links>;

  const CoveredImage* covered = nullptr;
  LinkBatch batch;
  PerLink<BeadLink*> links;
  PerLink<std::ptrdiff_t> fluid_cell;
  PerLink<Real*> incoming;
  PerLink<const Real*> outgoing, behind, arrived, two_behind, arrived_behind;
};

/// Collects links in batches and passes the batches to the link kernel. A batch is reflected when the next
/// one is complete, so that prefetched populations have arrived.
template <class Real>
class LinkReflection {
 public:
  LinkReflection(BeadScheme scheme, double slip, Populations& populations, const Coverage& coverage,
                 std::span<BeadOnLattice> beads, std::vector<LinkSums>& sums)
      : scheme_(scheme), slip_(slip), coverage_(coverage), beads_(beads), sums_(sums) {
    for (int out = 0; out < d3q19::directions; ++out) {
      const auto& c = d3q19::velocity[out];
      directions_[out] = {.c = {c[0], c[1], c[2]},
                          .velocity = {double(c[0]), double(c[1]), double(c[2])},
                          .weight = d3q19::weight(out),
                          .behind = populations.shift(out),
                          .outgoing = populations.outgoing_row<Real>(d3q19::opposite(out), 0),
                          .incoming = populations.incoming_row<Real>(out, 0)};
      arrived_[out] = populations.outgoing_row<Real>(out, 0);
    }
  }

  /// Adds links of fluid cells in one row.
  void add(std::span<BeadLink> links, const CoveredImage& covered) {
    const Index3 low = covered.image.low;
    const auto& c = d3q19::velocity[links.front().out];
    const int y = low[1] + links.front().from_low[1] + c[1], z = low[2] + links.front().from_low[2] + c[2];
    FluidRow row{.first = coverage_.cell(0, y, z), .low_x = low[0]};
    for (int step = 0; step < 3; ++step) {
      const Vec3 covered_cell = covered.from_centre(0, y + 1 - step, z + 1 - step);
      row.y[step] = covered_cell[1], row.z[step] = covered_cell[2];
    }
    for (BeadLink& link : links) {
      if (next_->covered != &covered || next_->batch.links == LinkBatch::max_links) begin_batch(&covered);
      add(link, row);
    }
  }

  /// Reflects the populations at all links that were added since the last call.
  void finish() {
    begin_batch(nullptr);
    begin_batch(nullptr);
  }

 private:
  /// Reflects the batch before the present one, and begins a new one of links of the image `covered`.
  void begin_batch(const CoveredImage* covered) {
    reflect(*last_);
    std::swap(last_, next_);
    next_->covered = covered;
  }

  void reflect(AddressedLinks<Real>& at) {
    LinkBatch& batch = at.batch;
    if (batch.links == 0) return;
    fetch(at);
    fill_lanes(batch);
    const BeadOnLattice& bead = beads_[at.covered->bead];
    LinkSums& sums = sums_[at.covered->bead];
    sums.reserve_terms(LinkBatch::max_links / LinkSums::lanes);
    if (!best_kernels<BeadKernels>().reflect<Real>(scheme_, batch, link_bead(bead, slip_), sums))
      add_one_by_one(batch.terms, batch.links, sums, bead);
    for (int k = 0; k < batch.links; ++k) *at.incoming[k] = static_cast<Real>(batch.returned[k]);
    add_stress(batch, beads_[at.covered->bead].impulse.stress);
    batch.links = 0;
  }

  /// Adds the stress by the impulses of the batch, which links exchange in their middle.
  static void add_stress(const LinkBatch& batch, StressSum& stress) {
    for (int k = 0; k < batch.links; ++k) {
      const Vec3 c(batch.cx[k], batch.cy[k], batch.cz[k]), covered(batch.x[k], batch.y[k], batch.z[k]);
      stress.add(covered + c / 2, {batch.terms[0][k], batch.terms[1][k], batch.terms[2][k]});
    }
  }

  /// Row of the fluid cells of some links.
  struct FluidRow {
    std::ptrdiff_t first;  ///< cell at x = 0
    int low_x;             ///< BeadImage::low of the image
    /// Coordinates of covered cells relative to the bead centre, by c + 1 for the component c of the
    /// direction.
    double y[3] = {}, z[3] = {};
  };

  void add(BeadLink& link, const FluidRow& row) {
    const int out = link.out;
    const Direction& along = directions_[out];
    const int x = row.low_x + link.from_low[0];
    const std::ptrdiff_t fluid_cell = row.first + x + along.c[0];
    const Real* outgoing = along.outgoing + fluid_cell;
    if (!link.fluid_is_own) {  // the rank that owns the fluid cell reflects
      link.outgoing = static_cast<double>(*outgoing);
      return;
    }
    AddressedLinks<Real>& at = *next_;
    LinkBatch& batch = at.batch;
    const int k = batch.links++;
    at.links[k] = &link;
    at.fluid_cell[k] = fluid_cell;
    at.outgoing[k] = outgoing;
    at.incoming[k] = along.incoming + fluid_cell;
    batch.x[k] = at.covered->from_centre(x, 0, 0)[0];
    batch.y[k] = row.y[along.c[1] + 1], batch.z[k] = row.z[along.c[2] + 1];
    batch.cx[k] = along.velocity[0], batch.cy[k] = along.velocity[1], batch.cz[k] = along.velocity[2];
    batch.weight[k] = along.weight;
    prefetch(at.incoming[k]);
    if (cells_behind_ < 2) prefetch(outgoing);
    if (cells_behind_ == 0) return;
    batch.fluid_behind[k] = link.fluid_behind;
    std::ptrdiff_t behind = link.fluid_behind > 0 ? along.behind : 0;
    if (is_beyond_row(x + 2 * along.c[0]) && behind != 0)
      behind = coverage_.wrapped_along_x(fluid_cell + behind, x + 2 * along.c[0]) - fluid_cell;
    at.behind[k] = outgoing + behind;
    at.arrived[k] = arrived_[out] + fluid_cell;
    prefetch(at.behind[k]);
    if (cells_behind_ == 1) {
      prefetch(at.arrived[k]);
      return;
    }
    at.two_behind[k] = link.fluid_behind > 1 ? at.behind[k] + along.behind : outgoing;
    at.arrived_behind[k] = at.arrived[k] + behind;
    prefetch(at.two_behind[k]);
    prefetch(at.arrived_behind[k]);
    if (fluid_cell == prefetched_cell_) return;
    prefetched_cell_ = fluid_cell;
#pragma GCC unroll 19
    for (const Real* row : arrived_) prefetch(row + fluid_cell);
  }

  /// Reads the populations that the links need. One short loop per array allows many memory accesses at the
  /// same time.
  void fetch(AddressedLinks<Real>& at) const {
    LinkBatch& batch = at.batch;
    const auto read = [&](const auto& from, double* to) {
      for (int k = 0; k < batch.links; ++k) to[k] = static_cast<double>(*from[k]);
    };
    read(at.outgoing, batch.outgoing);
    if (cells_behind_ >= 1) {
      read(at.behind, batch.behind);
      read(at.arrived, batch.arrived);
    }
    if (cells_behind_ >= 2) {
      read(at.two_behind, batch.two_behind);
      read(at.arrived_behind, batch.arrived_behind);
      find_speeds(at);
    }
    for (int k = 0; k < batch.links; ++k) at.links[k]->outgoing = batch.outgoing[k];
  }

  /// Evaluates the momentum of each fluid cell along its links, which follow each other.
  void find_speeds(AddressedLinks<Real>& at) const {
    LinkBatch& batch = at.batch;
    std::ptrdiff_t cell = -1;
    double u[3] = {};
    for (int k = 0; k < batch.links; ++k) {
      if (at.fluid_cell[k] != cell) {
        cell = at.fluid_cell[k];
        double f[d3q19::directions], density_deviation;
#pragma GCC unroll 19
        for (int i = 0; i < d3q19::directions; ++i) f[i] = static_cast<double>(arrived_[i][cell]);
        moments_of(f, density_deviation, u);
      }
      batch.speed[k] = -(batch.cx[k] * u[0] + batch.cy[k] * u[1] + batch.cz[k] * u[2]);
    }
  }

  /// A direction from covered to fluid cells. Addresses are those of the cell with index 0.
  struct Direction {
    int c[3];
    double velocity[3];  ///< c
    double weight;
    std::ptrdiff_t behind;  ///< from the fluid cell to the cell behind it
    const Real* outgoing;   ///< population from the fluid cell into the bead
    Real* incoming;         ///< reflected population
  };

  bool is_beyond_row(int x) const {
    return x < 0 || x >= cells_of_row_;
  }

  const BeadScheme scheme_;
  const double slip_;
  const Coverage& coverage_;
  std::span<BeadOnLattice> beads_;
  std::vector<LinkSums>& sums_;
  const int cells_of_row_ = coverage_.block_size()[0];
  std::array<Direction, d3q19::directions> directions_;
  std::array<const Real*, d3q19::directions> arrived_;  ///< outgoing populations of the cell with index 0
  const int cells_behind_ = cells_behind(scheme_);
  std::ptrdiff_t prefetched_cell_ = -1;
  AddressedLinks<Real> first_, second_;
  AddressedLinks<Real>*last_ = &first_, *next_ = &second_;
};

/// Refills an uncovered cell (refill.hpp) from the populations that streamed into it along the links that
/// ended in it.
void refill(Populations& populations, const ChangedCell& cell, const BeadLinks& links,
            const BeadOnLattice& bead, const RelaxationRates& rates) {
  const KernelBead b = link_bead(bead);
  const double r[3] = {cell.from_centre[0], cell.from_centre[1], cell.from_centre[2]};
  Arrivals arrivals;
  double sum = 0, weights = 0;
  links.for_each_link_of(cell.image, cell.local[0], cell.local[1], cell.local[2], [&](const BeadLink& link) {
    const int in = d3q19::opposite(link.out);
    const auto& to = d3q19::velocity[in];
    const double c[3] = {double(to[0]), double(to[1]), double(to[2])}, weight = d3q19::weight(in);
    arrivals.population[in] = link.outgoing;
    arrivals.is_known[in] = true;
    // estimate of the density deviation next to the covered cell, of first order in the velocity
    sum += link.outgoing - 3 * weight * speed_along(c, b.velocity, b.angular_velocity, r);
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

void BeadLinks::bounce_back_before_plane(Populations& populations, const Coverage& coverage,
                                         std::span<BeadOnLattice> beads, int z) {
  const std::span<const LinkSegment> segments = segments_before(z);
  if (segments.empty()) return;
  in_precision(populations.precision(), [&]<class Real>() {
    LinkReflection<Real> reflection(scheme_, multireflection_slip(rates_), populations, coverage, beads,
                                    sums_);
    for (const LinkSegment& segment : segments)
      reflection.add(links(segment), coverage.images().images[segment.image]);
    reflection.finish();
  });
}

void BeadLinks::transfer_impulses(std::span<BeadOnLattice> beads) {
  for (std::size_t b = 0; b < sums_.size(); ++b) {
    const std::array<OrderFreeSum, link_terms> total = sums_[b].take();
    Impulse& impulse = beads[b].impulse;
    impulse.fluid.add(std::span(total).first<6>());
    impulse.mass.add(total[6]);
    impulse.link_weight.add(total[7]);
  }
}

void BeadLinks::transfer_changed_cells(Populations& populations, const Coverage& coverage,
                                       std::span<const BeadOnLattice> beads_before,
                                       std::span<BeadOnLattice> beads) const {
  const auto add = [&](BeadOnLattice& bead, const ChangedCell& changed, double sign) {
    // values as stored in the precision of the populations
    const CellMoments fluid = cell_moments(populations, changed.cell);
    const Vec3 momentum = sign * fluid.momentum;
    bead.impulse.fluid.add(momentum, changed.from_centre.cross(momentum));
    bead.impulse.stress.add(changed.from_centre, momentum);
    bead.impulse.mass.add(sign * fluid.density_deviation);
  };
  for (const ChangedCell& covered : coverage.newly_covered()) add(beads[covered.bead], covered, 1);
  for (const ChangedCell& uncovered : coverage.uncovered()) {
    const BeadOnLattice& before = beads_before[uncovered.bead];
    const auto bead = std::ranges::lower_bound(beads, before.name, {}, &BeadOnLattice::name);
    if (bead == beads.end() || bead->name != before.name)
      throw not_finite_at(before);  // the bead moved by more than one cell in one step
    refill(populations, uncovered, *this, before, rates_);
    add(*bead, uncovered, -1);
  }
}

}  // namespace beadswim
