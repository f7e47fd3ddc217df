#include "spheres_in_fluid.hpp"

#include <numbers>
#include <numeric>
#include <utility>

#include "../lattice/set_equilibrium.hpp"

namespace beadswim::verification {
namespace {

constexpr std::array<Boundary, 3> periodic{Boundary::periodic, Boundary::periodic, Boundary::periodic};

double volume_of(const BeadOnLattice& bead) {
  return 4.0 / 3 * std::numbers::pi * std::pow(bead.radius, 3);
}

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

SpheresInFluid::SpheresInFluid(const Index3& cells, double relaxation_time, BeadScheme scheme,
                               const std::vector<Sphere>& spheres)
    : cells_(cells),
      decomposition_(cells, 1),
      populations_(cells, Precision::fp64, halo_content(scheme)),
      halo_(self_, decomposition_, periodic, halo_content(scheme)),
      rates_(relaxation_rates(relaxation_time)),
      coverage_(BlockInLattice{.block = {.size = cells}, .cells = cells, .boundary = periodic}, populations_),
      links_(scheme, rates_),
      saturated_cells_(BlockInLattice{.block = {.size = cells}, .cells = cells, .boundary = periodic},
                       lattice_viscosity(1 / rates_.symmetric)),
      beads_(beads_of(spheres)),
      inner_momentum_(spheres.size()),
      held_mass_(spheres.size(), 0.0) {
  coverage_.update(beads_);
  place_spheres();
}

/// Determines the cells that the spheres cover, and their links or saturated cells.
void SpheresInFluid::place_spheres() {
  fluid_cells_ = volume();
  if (has_links(links_.scheme())) {
    links_.find(coverage_);
    coverage_.for_each_own_covered_cell([&](std::ptrdiff_t, int, const Vec3&) { --fluid_cells_; });
  } else {
    saturated_cells_.find(beads_);
    for (const BeadOnLattice& bead : beads_) fluid_cells_ -= volume_of(bead);
  }
}

void SpheresInFluid::start_fluid(const Vec3& velocity) {
  for_each_cell(populations_, [&](const Index3&, std::ptrdiff_t cell) {
    set_equilibrium(populations_, cell, 0, velocity);
  });
  for (std::size_t b = 0; b < beads_.size(); ++b)
    inner_momentum_[b] = {.force = volume_of(beads_[b]) * velocity, .torque = Vec3::Zero()};
  fluid_momentum_ = counted_fluid().momentum;
}

void SpheresInFluid::hold_fluid_momentum(const Vec3& momentum) {
  constexpr double corrected_part = 0.02;
  const Vec3 missing = corrected_part * (momentum - fluid_momentum_);
  body_force = (0.5 * (taken_ + taken_before_) + missing) / fluid_cells_;
}

/// Returns the impulse and angular impulse that the last step transferred to a sphere.
Load SpheresInFluid::take_load(int sphere) {
  Impulse& impulse = beads_[sphere].impulse;
  Load load = impulse.fluid.value();
  if (has_links(links_.scheme())) {
    held_mass_[sphere] += impulse.mass.value();
    beads_[sphere].mass_source = returned_mass(held_mass_[sphere], impulse.link_weight.value());
  } else {
    const Vec3 inner_body_force = volume_of(beads_[sphere]) * body_force;
    Load inner = impulse.inner.value();
    inner.force += inner_body_force;
    load.force += inner.force - inner_momentum_[sphere].force - inner_body_force;
    load.torque += inner.torque - inner_momentum_[sphere].torque;
    inner_momentum_[sphere] = inner;
  }
  impulse = {};
  return load;
}

std::vector<Load> SpheresInFluid::step() {
  saturated_cells_.begin_step(body_force);
  const auto before_row = [&](int y, int z) {
    if (!has_links(links_.scheme()))
      saturated_cells_.apply_forces_before_row(populations_, beads_, y, z);
    else if (y == 0)
      links_.bounce_back_before_plane(populations_, coverage_, beads_, z);
  };
  step_fluid(populations_, halo_, rates_, body_force, {.before_row = before_row});
  links_.transfer_impulses(beads_);
  saturated_cells_.transfer_impulses(beads_);
  force_on_fluid_part_ = Vec3::Zero();
  for (const SaturatedForce& cell : saturated_cells_.forces())
    force_on_fluid_part_ += cell.fluid_fraction * cell.force;

  fluid_momentum_ += fluid_cells_ * body_force;
  taken_before_ = std::exchange(taken_, Vec3::Zero());
  std::vector<Load> loads;
  for (int b = 0; b < std::ssize(beads_); ++b) {
    loads.push_back(take_load(b));
    taken_ += loads.back().force;
  }
  fluid_momentum_ -= taken_;
  return loads;
}

void SpheresInFluid::move() {
  const std::vector<BeadOnLattice> before = beads_;
  for (BeadOnLattice& bead : beads_) bead.motion.position += bead.motion.velocity;
  coverage_.update(beads_);
  if (has_links(links_.scheme())) links_.transfer_changed_cells(populations_, coverage_, before, beads_);
  place_spheres();
}

CellMoments SpheresInFluid::counted_fluid() const {
  CellMoments sum;
  const bool by_links = has_links(links_.scheme());
  for_each_cell(populations_, [&](const Index3& p, std::ptrdiff_t cell) {
    if (by_links && coverage_.is_covered(p[0], p[1], p[2])) return;
    const CellMoments moments = cell_moments(populations_, cell);
    sum.density_deviation += moments.density_deviation;
    sum.momentum += moments.momentum;
  });
  for (const BeadOnLattice& bead : beads_) {  // handed over by the last move, not yet returned by step()
    sum.density_deviation += bead.impulse.mass.value();
    sum.momentum += bead.impulse.fluid.value().force;
  }
  for (const Load& inner : inner_momentum_) {
    if (!by_links) sum.momentum -= inner.force;
  }
  return sum;
}

double SpheresInFluid::held_mass() const {
  return std::accumulate(held_mass_.begin(), held_mass_.end(), 0.0);
}

}  // namespace beadswim::verification
