#include "spheres_in_fluid.hpp"

#include <numeric>
#include <utility>

namespace beadswim::verification {
namespace {

constexpr std::array<Wall, 3> periodic{Wall::periodic, Wall::periodic, Wall::periodic};

/// As in coupled_step.cpp.
constexpr double returned_part = 0.1;

std::vector<BeadOnLattice> beads_of(const std::vector<Sphere>& spheres) {
  std::vector<BeadOnLattice> beads;
  for (const Sphere& sphere : spheres) {
    const BeadName name{.swimmer = static_cast<int>(beads.size()), .bead = 0};
    beads.push_back({.name = name,
                     .owner = 0,
                     .radius = sphere.radius,
                     .motion = {.position = sphere.centre},
                     .impulse = {}});
  }
  return beads;
}

}  // namespace

SpheresInFluid::SpheresInFluid(const Index3& cells, double relaxation_time, LinkScheme scheme,
                               const std::vector<Sphere>& spheres)
    : cells_(cells),
      decomposition_(cells, 1),
      populations_(cells),
      halo_(self_, decomposition_, periodic),
      rates_(relaxation_rates(relaxation_time)),
      coverage_(block_in_lattice(decomposition_, 0, periodic), populations_),
      links_(scheme),
      beads_(beads_of(spheres)),
      sums_(spheres.size()),
      held_mass_(spheres.size(), 0.0) {
  coverage_.update(beads_);
  links_.find(coverage_);
  count_fluid_cells();
}

void SpheresInFluid::count_fluid_cells() {
  fluid_cells_ = cells_.cast<long>().prod();
  coverage_.for_each_own_covered_cell([&](std::ptrdiff_t, int, const Vec3&) { --fluid_cells_; });
}

void SpheresInFluid::start_fluid(const Vec3& velocity) {
  for_each_cell(populations_, [&](const Index3&, std::ptrdiff_t cell) {
    set_equilibrium(populations_, cell, 0, velocity);
  });
  fluid_momentum_ = counted_fluid().momentum;
}

void SpheresInFluid::hold_fluid_momentum(const Vec3& momentum) {
  constexpr double corrected_part = 0.02;
  const Vec3 missing = corrected_part * (momentum - fluid_momentum_);
  body_force = (0.5 * (taken_ + taken_before_) + missing) / static_cast<double>(fluid_cells_);
}

void SpheresInFluid::accelerate_row(int y, int z) {
  for (int i = 1; i < d3q19::directions; ++i) {
    const auto& c = d3q19::velocity[i];
    const double share = 3 * d3q19::weight(i) * body_force.dot(Vec3(c[0], c[1], c[2]));
    if (share == 0) continue;
    double* row = populations_.next_outgoing_row<double>(i, populations_.cell(0, y, z));
    for (int x = 0; x < cells_[0]; ++x) row[x] += share;
  }
}

std::vector<Load> SpheresInFluid::step() {
  BeadBoundary boundary{coverage_, links_, beads_, sums_};
  halo_.fill(populations_);
  BlockSweep sweep(populations_, rates_, RowEnds::left_to_halo);
  for (int n = 0; n < cells_[2]; ++n) {
    const int z = plane_in_order(n, cells_[2]);
    for (int y = 0; y < cells_[1]; ++y) {
      boundary.bounce_back_before_row(populations_, y, z);
      sweep.row(y, z);
      accelerate_row(y, z);
    }
  }
  sweep.finish();
  hand_over_impulses(sums_, beads_);

  fluid_momentum_ += static_cast<double>(fluid_cells_) * body_force;
  taken_before_ = std::exchange(taken_, Vec3::Zero());
  std::vector<Load> loads;
  for (std::size_t b = 0; b < beads_.size(); ++b) {
    Impulse& impulse = beads_[b].impulse;
    loads.push_back(impulse.value());
    taken_ += loads.back().force;
    held_mass_[b] += impulse.mass.value();
    beads_[b].mass_source = returned_part * held_mass_[b] / impulse.link_weight.value();
    impulse = {};
  }
  fluid_momentum_ -= taken_;
  return loads;
}

void SpheresInFluid::move() {
  const std::vector<BeadOnLattice> before = beads_;
  for (BeadOnLattice& bead : beads_) bead.motion.position += bead.motion.velocity;
  coverage_.update(beads_);
  hand_over_changed_cells(populations_, coverage_, links_, before, beads_);
  links_.find(coverage_);
  count_fluid_cells();
}

CellMoments SpheresInFluid::counted_fluid() const {
  CellMoments sum;
  for_each_cell(populations_, [&](const Index3&, std::ptrdiff_t cell) {
    if (coverage_.is_covered(cell)) return;
    const CellMoments moments = cell_moments(populations_, cell);
    sum.density_deviation += moments.density_deviation;
    sum.momentum += moments.momentum;
  });
  for (const BeadOnLattice& bead : beads_) {  // handed over by the last move, not yet returned by step()
    sum.density_deviation += bead.impulse.mass.value();
    sum.momentum += bead.impulse.value().force;
  }
  return sum;
}

double SpheresInFluid::held_mass() const {
  return std::accumulate(held_mass_.begin(), held_mass_.end(), 0.0);
}

}  // namespace beadswim::verification
