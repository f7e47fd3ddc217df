#include <algorithm>
#include <array>
#include <vector>

#include "bead_kernels.hpp"
#include "beadswim/core/kernel.hpp"
#include "beadswim/coupling/fault.hpp"
#include "beadswim/coupling/saturated_cell.hpp"
#include "beadswim/coupling/saturated_cells.hpp"

namespace beadswim {
/// Applies the forces of beads on the fluid in the cells of one row. Passes cells that a single bead touches
/// to the vectorised kernel. Evaluates cells that several beads touch one by one.
template <class Real>
class SaturatedCells::RowUpdate {
 public:
  RowUpdate(SaturatedCells& cells, Populations& populations, std::span<BeadOnLattice> beads, int y, int z)
      : cells_(cells),
        beads_(beads),
        runs_(cells.runs(y, z)),
        populations_(populations),
        first_(populations.cell(0, y, z)) {}

  void row() {
    for (std::size_t n = 0; n < runs_.size(); ++n) {
      const SaturatedRun& run = runs_[n];
      int start = run.low;  // first of the next consecutive cells that no other bead touches
      for (int x = run.low; x < run.high; ++x) {
        if (!is_shared(n, x)) continue;
        push(run, start, x);
        start = x + 1;
        const auto has_x = [x](const SaturatedRun& other) { return other.contains(x); };
        if (std::ranges::none_of(runs_.first(n), has_x)) push_shared(x);
      }
      push(run, start, run.high);
    }
  }

 private:
  bool is_shared(std::size_t n, int x) const {
    for (std::size_t other = 0; other < runs_.size(); ++other) {
      if (other != n && runs_[other].contains(x)) return true;
    }
    return false;
  }

  /// Applies the force of the bead on the fluid in the cells [low, high) of a run. No other bead touches
  /// these cells.
  void push(const SaturatedRun& run, int low, int high) {
    constexpr int max_cells = SaturatedBatch<Real>::max_cells, lanes = SaturatedSums::lanes;
    for (; low < high; low += max_cells) {
      batch_.cells = std::min(max_cells, high - low);
      for (int i = 0; i < d3q19::directions; ++i)
        batch_.places[i] = populations_.template incoming_row<Real>(i, first_ + low);
      const int places = (batch_.cells + lanes - 1) / lanes * lanes;
      for (int k = 0; k < places; ++k) {
        batch_.solid_fraction[k] = k < batch_.cells ? cells_.fraction(run, low + k) : 0;
        batch_.x[k] = run.from_centre(low + k)[0];
      }
      batch_.y = run.y, batch_.z = run.z;
      push_batch(run.bead);
      for (int k = 0; k < batch_.cells; ++k) {
        const Vec3 impulse(batch_.terms[0][k], batch_.terms[1][k], batch_.terms[2][k]);
        beads_[run.bead].impulse.stress.add(run.from_centre(low + k), impulse);
        cells_.forces_.push_back(
            {.cell = first_ + low + k, .fluid_fraction = 1 - batch_.solid_fraction[k], .force = -impulse});
      }
    }
  }

  void push_batch(int b) {
    const BeadMotion& motion = beads_[b].motion;
    const Vec3 v = motion.velocity - 0.5 * cells_.body_force_, &omega = motion.angular_velocity;
    const KernelBead bead{.velocity = {v[0], v[1], v[2]},
                          .angular_velocity = {omega[0], omega[1], omega[2]},
                          .viscosity = cells_.viscosity_};
    SaturatedSums& sums = cells_.sums_[b];
    sums.reserve_terms(SaturatedBatch<Real>::max_cells / SaturatedSums::lanes);
    if (!best_kernels<BeadKernels>().push(batch_, bead, sums))
      add_one_by_one(batch_.terms, batch_.cells, sums, beads_[b]);
  }

  /// Part of a bead in a cell that several beads touch. sigma: coupling rate; velocity: of the bead at the
  /// cell.
  struct Share {
    int bead;
    double solid_fraction, sigma;
    Vec3 from_centre, velocity;
  };

  /// Applies the forces of several beads on the fluid in cell x. The equations of saturated_cell.hpp apply,
  /// with the force F = sum of sigma (u_b - v) over the beads. u_b: velocity of a bead at the cell; v:
  /// momentum of the fluid, averaged over the step.
  void push_shared(int x) {
    std::vector<Share> shares;
    double sigma = 0, fluid_fraction = 1;
    Vec3 pull = Vec3::Zero();
    for (const SaturatedRun& run : runs_) {
      if (!run.contains(x)) continue;
      const Vec3 r = run.from_centre(x);
      const double fraction = cells_.fraction(run, x);
      shares.push_back({.bead = run.bead,
                        .solid_fraction = fraction,
                        .sigma = 3 * cells_.viscosity_ * resistance(fraction),
                        .from_centre = r,
                        .velocity = beads_[run.bead].velocity_at(r) - 0.5 * cells_.body_force_});
      sigma += shares.back().sigma;
      pull += shares.back().sigma * shares.back().velocity;
      fluid_fraction -= fraction;
    }
    std::array<Real*, d3q19::directions> places;
    double f[d3q19::directions], density, u[3], gained[3];
    for (int i = 0; i < d3q19::directions; ++i) {
      places[i] = populations_.template incoming_row<Real>(i, first_ + x);
      f[i] = static_cast<double>(*places[i]);
    }
    moments_of(f, density, u);
    const Vec3 before(u[0], u[1], u[2]), force = (pull - sigma * before) / (1 + sigma / 2);
    const double pushed[3] = {u[0] + force[0], u[1] + force[1], u[2] + force[2]};
    const double squares = squares_difference(u, pushed);
    for (int i = 0; i < d3q19::directions; ++i) {
      *places[i] = static_cast<Real>(f[i] + equilibrium_change(i, u, pushed, squares));
      f[i] = static_cast<double>(*places[i]) - f[i];
    }
    moments_of(f, density, gained);  // after the populations were rounded
    const Vec3 change(gained[0], gained[1], gained[2]), mean = before + 0.5 * force;
    Vec3 rest = change;  // the first bead gets the remainder, so that rounding loses no momentum
    for (std::size_t n = shares.size(); n-- > 0;) {
      const Share& share = shares[n];
      const Vec3 part = n == 0 ? rest : Vec3(share.sigma * (share.velocity - mean));
      rest -= part;
      add_momentum(share, 0, -part);
      beads_[share.bead].impulse.stress.add(share.from_centre, -part);
      add_momentum(share, 6, share.solid_fraction * (before + change));
    }
    cells_.forces_.push_back({.cell = first_ + x, .fluid_fraction = fluid_fraction, .force = change});
  }

  void add_momentum(const Share& share, int first_term, const Vec3& p) {
    const Vec3 l = share.from_centre.cross(p);
    std::array<OrderFreeSum, saturated_terms>& sums = cells_.sums_[share.bead].sums;
    for (int a = 0; a < 3; ++a) {
      sums[first_term + a].add(p[a]);
      sums[first_term + 3 + a].add(l[a]);
    }
  }

  SaturatedCells& cells_;
  std::span<BeadOnLattice> beads_;
  std::span<const SaturatedRun> runs_;
  Populations& populations_;
  std::ptrdiff_t first_;
  SaturatedBatch<Real> batch_;
};

void SaturatedCells::begin_step(const Vec3& body_force) {
  body_force_ = body_force;
  forces_.clear();
}

void SaturatedCells::apply_forces_before_row(Populations& populations, std::span<BeadOnLattice> beads, int y,
                                             int z) {
  if (runs(y, z).empty()) return;
  in_precision(populations.precision(),
               [&]<class Real>() { RowUpdate<Real>(*this, populations, beads, y, z).row(); });
}

void SaturatedCells::transfer_impulses(std::span<BeadOnLattice> beads) {
  for (std::size_t b = 0; b < sums_.size(); ++b) {
    const std::array<OrderFreeSum, saturated_terms> total = sums_[b].take();
    beads[b].impulse.fluid.add(std::span(total).first<6>());
    beads[b].impulse.inner.add(std::span(total).last<6>());
  }
}

}  // namespace beadswim
