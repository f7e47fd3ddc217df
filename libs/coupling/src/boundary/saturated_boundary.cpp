#include "beadswim/coupling/saturated_boundary.hpp"

#include <algorithm>
#include <array>

#include "add_one_by_one.hpp"
#include "beadswim/core/kernel_choice.hpp"
#include "beadswim/coupling/saturated_cell.hpp"
#include "beadswim/lattice/d3q19.hpp"
#include "saturated_kernel.hpp"

namespace beadswim {
namespace {

/// A cell that several beads touch. The equations of saturated_cell.hpp apply, with the force F = sum of
/// sigma (u_b - v) over the beads. sigma: coupling rate of a bead; u_b: velocity of the bead at the cell; v:
/// momentum of the fluid, averaged over the step.
class SharedCell {
 public:
  void add(const SaturatedRun& run, double solid_fraction, double viscosity, const Vec3& from_centre,
           const Vec3& velocity) {
    const double sigma = 3 * viscosity * resistance(solid_fraction);
    shares_.push_back({.bead = run.bead,
                       .solid_fraction = solid_fraction,
                       .sigma = sigma,
                       .from_centre = from_centre,
                       .velocity = velocity});
    sigma_ += sigma;
    pull_ += sigma * velocity;
  }

  double fluid_fraction() const {
    double fraction = 1;
    for (const Share& share : shares_) fraction -= share.solid_fraction;
    return fraction;
  }

  /// Returns the force F on fluid that streams in with momentum u.
  Vec3 force(const Vec3& u) const { return (pull_ - sigma_ * u) / (1 + sigma_ / 2); }

  /// Divides the change of the momentum of the fluid in this step among the beads. u: momentum before the
  /// change; change: actual change, after the populations were rounded.
  void distribute_change(std::vector<SaturatedSums>& sums, const Vec3& u, const Vec3& change) const {
    const Vec3 mean = u + 0.5 * force(u);
    Vec3 rest = change;  // the first bead gets the remainder, so that rounding loses no momentum
    for (std::size_t n = shares_.size(); n-- > 0;) {
      const Share& share = shares_[n];
      const Vec3 part = n == 0 ? rest : Vec3(share.sigma * (share.velocity - mean));
      rest -= part;
      add_momentum(sums[share.bead], 0, -part, share.from_centre);
      add_momentum(sums[share.bead], 6, share.solid_fraction * (u + change), share.from_centre);
    }
  }

 private:
  static void add_momentum(SaturatedSums& sums, int first_term, const Vec3& p, const Vec3& from_centre) {
    const Vec3 l = from_centre.cross(p);
    for (int a = 0; a < 3; ++a) {
      sums.sums[first_term + a].add(p[a]);
      sums.sums[first_term + 3 + a].add(l[a]);
    }
  }

  struct Share {
    int bead;
    double solid_fraction, sigma;
    Vec3 from_centre, velocity;
  };
  std::vector<Share> shares_;
  double sigma_ = 0;
  Vec3 pull_ = Vec3::Zero();
};

/// Applies the forces of beads on the fluid in the cells of one row. Passes cells that a single bead touches
/// to the vectorised kernel. Evaluates cells that several beads touch one by one.
template <class Real>
class SaturatedRowUpdate {
 public:
  SaturatedRowUpdate(SaturatedBoundary& boundary, Populations& populations, int y, int z)
      : boundary_(boundary),
        runs_(boundary.cells.runs(y, z)),
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
        batch_.solid_fraction[k] = k < batch_.cells ? boundary_.cells.fraction(run, low + k) : 0;
        batch_.x[k] = run.from_centre(low + k)[0];
      }
      batch_.y = run.y, batch_.z = run.z;
      push_batch(run.bead);
      for (int k = 0; k < batch_.cells; ++k)
        boundary_.forces.push_back(
            {.cell = first_ + low + k,
             .fluid_fraction = 1 - batch_.solid_fraction[k],
             .force = {-batch_.terms[0][k], -batch_.terms[1][k], -batch_.terms[2][k]}});
    }
  }

  void push_batch(int b) {
    const BeadMotion& motion = boundary_.beads[b].motion;
    const Vec3 v = motion.velocity - 0.5 * boundary_.body_force, &omega = motion.angular_velocity;
    const SaturatedBead bead{.velocity = {v[0], v[1], v[2]},
                             .angular_velocity = {omega[0], omega[1], omega[2]},
                             .viscosity = boundary_.viscosity};
    SaturatedSums& sums = boundary_.sums[b];
    sums.reserve_terms(SaturatedBatch<Real>::max_cells / SaturatedSums::lanes);
    if (!best_kernels<SaturatedKernels>().push(batch_, bead, sums))
      add_one_by_one(batch_, batch_.cells, sums, boundary_.beads[b]);
  }

  void push_shared(int x) {
    SharedCell cell;
    for (const SaturatedRun& run : runs_) {
      if (!run.contains(x)) continue;
      const Vec3 r = run.from_centre(x);
      cell.add(run, boundary_.cells.fraction(run, x), boundary_.viscosity, r,
               boundary_.beads[run.bead].velocity_at(r) - 0.5 * boundary_.body_force);
    }
    std::array<Real*, d3q19::directions> places;
    double f[d3q19::directions], density, u[3], gained[3];
    for (int i = 0; i < d3q19::directions; ++i) {
      places[i] = populations_.template incoming_row<Real>(i, first_ + x);
      f[i] = static_cast<double>(*places[i]);
    }
    moments_of(f, density, u);
    const Vec3 before(u[0], u[1], u[2]), force = cell.force(before);
    const double pushed[3] = {u[0] + force[0], u[1] + force[1], u[2] + force[2]};
    const double squares = squares_difference(u, pushed);
    for (int i = 0; i < d3q19::directions; ++i) {
      *places[i] = static_cast<Real>(f[i] + equilibrium_change(i, u, pushed, squares));
      f[i] = static_cast<double>(*places[i]) - f[i];
    }
    moments_of(f, density, gained);
    const Vec3 change(gained[0], gained[1], gained[2]);
    cell.distribute_change(boundary_.sums, before, change);
    boundary_.forces.push_back(
        {.cell = first_ + x, .fluid_fraction = cell.fluid_fraction(), .force = change});
  }

  SaturatedBoundary& boundary_;
  std::span<const SaturatedRun> runs_;
  Populations& populations_;
  std::ptrdiff_t first_;
  SaturatedBatch<Real> batch_;
};

}  // namespace

void SaturatedBoundary::apply_forces_before_row(Populations& populations, int y, int z) {
  if (cells.runs(y, z).empty()) return;
  in_precision(populations.precision(),
               [&]<class Real>() { SaturatedRowUpdate<Real>(*this, populations, y, z).row(); });
}

void transfer_impulses(std::span<SaturatedSums> sums, std::span<BeadOnLattice> beads) {
  for (std::size_t b = 0; b < beads.size(); ++b) {
    const std::array<OrderFreeSum, saturated_terms> total = sums[b].take();
    Impulse& impulse = beads[b].impulse;
    for (int a = 0; a < 3; ++a) {
      impulse.linear[a].add(total[a]);
      impulse.angular[a].add(total[3 + a]);
      impulse.inner_linear[a].add(total[6 + a]);
      impulse.inner_angular[a].add(total[9 + a]);
    }
  }
}

}  // namespace beadswim
