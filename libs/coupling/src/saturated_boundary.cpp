#include "beadswim/coupling/saturated_boundary.hpp"

#include <algorithm>
#include <array>

#include "beadswim/coupling/saturated_cell.hpp"
#include "beadswim/lattice/moments.hpp"

namespace beadswim {
namespace {

/// The beads that touch a cell: the law of saturated_cell.hpp with F = sum over beads of sigma (u_b - v).
class CellForces {
 public:
  void add(int bead, double solid_fraction, double viscosity, const Vec3& from_centre, const Vec3& velocity) {
    if (count_ == most) return;
    const double sigma = 3 * viscosity * resistance(solid_fraction);
    shares_[count_++] = {bead, solid_fraction, sigma, from_centre, velocity};
    sigma_ += sigma;
    pull_ += sigma * velocity;
  }

  /// F on fluid that streams in with momentum u.
  Vec3 force(const Vec3& u) const { return (pull_ - sigma_ * u) / (1 + sigma_ / 2); }

  /// Hands the fluid's change of momentum from u, as it came out, to the beads: to each its part.
  void hand_over(std::span<BeadOnLattice> beads, const Vec3& u, const Vec3& change) const {
    const Vec3 mean = u + 0.5 * force(u);
    Vec3 rest = change;  // all of it is handed over, whatever rounding did
    for (int n = count_ - 1; n >= 0; --n) {
      const Share& share = shares_[n];
      const Vec3 part = n == 0 ? rest : Vec3(share.sigma * (share.velocity - mean));
      rest -= part;
      beads[share.bead].impulse.add(-part, share.from_centre);
      beads[share.bead].impulse.add_inner(share.solid_fraction * (u + change), share.from_centre);
    }
  }

 private:
  static constexpr int most = 8;  ///< beads that touch one cell; they would overlap
  struct Share {
    int bead;
    double solid_fraction, sigma;
    Vec3 from_centre, velocity;
  };
  std::array<Share, most> shares_;
  int count_ = 0;
  double sigma_ = 0;
  Vec3 pull_ = Vec3::Zero();
};

/// Adds e_i(u + F) - e_i(u) to the populations that the cell receives; returns the change of their momentum
/// as they are stored.
template <class Real>
Vec3 push(const std::array<Real*, d3q19::directions>& places, const double (&f)[d3q19::directions],
          const double (&u)[3], const Vec3& force) {
  const double pushed[3] = {u[0] + force[0], u[1] + force[1], u[2] + force[2]};
  double change[d3q19::directions], r, gained[3];
  for (int i = 0; i < d3q19::directions; ++i) {
    *places[i] = static_cast<Real>(f[i] + equilibrium_change(i, u, pushed));
    change[i] = static_cast<double>(*places[i]) - f[i];
  }
  moments_of(change, r, gained);
  return {gained[0], gained[1], gained[2]};
}

}  // namespace

void SaturatedBoundary::push_before_row(Populations& populations, int y, int z) {
  const std::span<const SaturatedRun> runs = cells.runs(y, z);
  if (runs.empty()) return;
  const std::ptrdiff_t first = populations.cell(0, y, z);
  in_precision(populations.precision(), [&]<class Real>() {
    for (std::size_t n = 0; n < runs.size(); ++n) {
      for (int x = runs[n].low; x < runs[n].high; ++x) {
        const auto has_x = [x](const SaturatedRun& run) { return run.contains(x); };
        if (std::ranges::any_of(runs.first(n), has_x)) continue;  // done
        CellForces forces;
        for (const SaturatedRun& run : runs.subspan(n)) {
          if (!has_x(run)) continue;
          const Vec3 from_centre = run.from_centre(x);
          forces.add(run.bead, cells.fraction(run, x), viscosity, from_centre,
                     beads[run.bead].velocity_at(from_centre));
        }
        std::array<Real*, d3q19::directions> places;
        double f[d3q19::directions], r, u[3];
        for (int i = 0; i < d3q19::directions; ++i) {
          places[i] = populations.incoming_row<Real>(i, first + x);
          f[i] = static_cast<double>(*places[i]);
        }
        moments_of(f, r, u);
        const Vec3 before(u[0], u[1], u[2]);
        const Vec3 gained = push(places, f, u, forces.force(before));
        forces.hand_over(beads, before, gained);
      }
    }
  });
}

}  // namespace beadswim
