#include "beadswim/coupling/coupled_system.hpp"

#include <algorithm>

#include "beadswim/swimmers/swimmer_dynamics.hpp"

namespace beadswim {
namespace {

double mass_of_beads(const CoupledScene& scene) {
  double sum = 0;
  for (const PlacedSwimmer& swimmer : scene.swimmers) {
    for (const Bead& bead : scene.type_of(swimmer).beads) sum += mass(bead);
  }
  return sum;
}

}  // namespace

std::optional<Fault> conservation_fault(const CoupledScene& scene, const SceneTotals& first,
                                        const SceneTotals& now, double bead_speed) {
  // Largest permitted changes of the momentum, divided by the momentum of all beads at their largest speed,
  // and of the mass, divided by the mass of the fluid.
  const bool is_double = scene.precision == Precision::fp64;
  const double max_momentum = is_double ? 1e-6 : 0.05, max_mass = is_double ? 1e-9 : 1e-5;
  const double lost_mass = std::abs(now.mass_excess - first.mass_excess);
  if (!(lost_mass <= max_mass)) return Fault{.kind = FaultKind::mass, .value = lost_mass};

  const bool periodic =
      std::ranges::all_of(scene.boundary, [](Boundary ends) { return ends == Boundary::periodic; });
  constexpr double slowest = 1e-9;  // lower bound; avoids a division by zero for beads at rest [cell/step]
  const double scale = mass_of_beads(scene) * std::max(bead_speed, slowest);
  const double gained = (now.momentum - first.momentum).norm() / scale;
  if (periodic && !(gained <= max_momentum)) return Fault{.kind = FaultKind::momentum, .value = gained};
  return std::nullopt;
}

FluidTotals CoupledSystem::fluid_totals() const {
  const Populations& populations = levels_.finest().populations;
  FluidTotals fluid = block_totals(populations);
  if (has_links()) {
    FluidTotals covered_cells;
    coverage_.for_each_own_covered_cell(
        [&](std::ptrdiff_t cell, int, const Vec3&) { covered_cells.add(cell_moments(populations, cell)); });
    fluid.subtract(covered_cells);
    return fluid;
  }
  for (const SwimmerState& swimmer : owned_) {
    for (const Load& inner : swimmer.inner_momentum) fluid.add({.momentum = -inner.force});
  }
  return fluid;
}

FluidTotals CoupledSystem::volume_of_beads() const {
  FluidTotals totals;
  const Vec3 half_impulse = 0.5 * levels_.body_impulses().back().acted;
  if (has_links()) {
    coverage_.for_each_own_covered_cell([&](std::ptrdiff_t, int bead, const Vec3& from_centre) {
      totals.add({.momentum = beads_[bead].velocity_at(from_centre) + half_impulse});
    });
    return totals;
  }
  for_each_owned_bead([&](const SwimmerState& swimmer, std::size_t b, const Bead& bead) {
    // The momentum of the fluid within the bead lacks the last impulse of the body force.
    const Vec3 velocity = swimmer.motion[b].velocity - half_impulse;
    totals.add({.momentum = mass(bead) / bead.density * velocity});
  });
  for (const auto& [cell, fluid_fraction, force] : saturated_forces())
    totals.add({.momentum = -0.5 * fluid_fraction * force});
  return totals;
}

double CoupledSystem::excess_mass(const Bead& bead) const {
  const double added = scene_.corrects_delay ? delay_density(bead, scene_.relaxation_time) : 0;
  return mass(bead) * (1 - (1 + added) / bead.density);
}

FluidTotals CoupledSystem::excess_totals() const {
  FluidTotals totals;
  for_each_owned_bead([&](const SwimmerState& swimmer, std::size_t b, const Bead& bead) {
    totals.add({.momentum = excess_mass(bead) * swimmer.motion[b].velocity});
  });
  return totals;
}

FluidTotals CoupledSystem::bead_totals() const {
  FluidTotals totals;
  for_each_owned_bead([&](const SwimmerState& swimmer, std::size_t b, const Bead& bead) {
    totals.add(
        {.density_deviation = swimmer.held_mass[b], .momentum = mass(bead) * swimmer.motion[b].velocity});
    totals.add({.momentum = 0.5 * swimmer.last_impulse[b].force});
  });
  const auto add = [&](const Impulse& impulse) {  // exact sums: rounding would depend on the number of ranks
    totals.density_deviation.add(impulse.mass);
    for (int a = 0; a < 3; ++a) totals.momentum[a].add(impulse.fluid.sums[a]);
  };
  for (const BeadOnLattice& bead : beads_) add(bead.impulse);
  for (const auto& [name, impulse] : pending_impulses_) add(impulse);
  return totals;
}

SceneTotals CoupledSystem::totals() {
  FluidTotals everything, all_cells;
  std::vector<FluidTotals> coarser_totals;
  if_state_is_finite([&] {
    everything = all_cells = fluid_totals();
    everything.add(bead_totals());
    all_cells.add(volume_of_beads());
    coarser_totals = levels_.coarser_totals();
  });
  everything = sum_over_ranks(everything, communicator_);
  all_cells = sum_over_ranks(all_cells, communicator_);
  const CellMoments coarser = levels_.sum_of_coarser(std::move(coarser_totals), communicator_);
  const double cells = scene_.cells.cast<double>().prod();
  const Vec3 half_impulse = levels_.half_impulse();
  // Momentum is conserved if a body force that balances driving forces is counted with these forces.
  const Vec3 ahead = has_net_force_ ? progress_.unbalanced : half_impulse;
  return {.momentum = everything.momentum_value() + coarser.momentum - ahead,
          .mean_flow = (all_cells.momentum_value() + coarser.momentum - half_impulse) / cells,
          .mass_excess = (everything.density_deviation.value() + coarser.density_deviation) / cells};
}

}  // namespace beadswim
