#include <algorithm>
#include <utility>

#include "beadswim/coupling/coupled_system.hpp"

// One time step of the coupled method. The populations are stored after the collision at time n; a step
// advances fluid and beads from n to n + 1. See docs/method/momentum-exchange.md, staircase-beads.md,
// interpolated-beads.md, multireflection.md, saturated-cells.md.

namespace beadswim {
namespace {

/// Adds to the impulse on a bead the change of the momentum of the fluid within the bead (`inner` before,
/// `inner_now` after the step). This fluid moves with the bead, but its inertia is not part of the inertia of
/// the bead. The force that accelerates this fluid must therefore not act on the bead.
void add_change(Load& impulse, Load& inner, const Load& inner_now) {
  impulse.force += inner_now.force - inner.force;
  impulse.torque += inner_now.torque - inner.torque;
  inner = inner_now;
}

/// Predicts the velocities of the beads at the end of the next step for the case that no bead is close to
/// another. Extrapolates the change of velocity in this step linearly, after subtraction of the impulses from
/// close beads. before: motion before this step; close: impulses from close beads in this step.
void predict(SwimmerState& swimmer, const SwimmerMotion& before, const SwimmerLoads& close,
             const SwimmerType& type) {
  for (std::size_t b = 0; b < before.size(); ++b) {
    const BeadMotion& now = swimmer.motion[b];
    swimmer.predicted[b] = {
        .linear = 2 * now.velocity - before[b].velocity - close[b].force / mass(type.beads[b]),
        .angular = 2 * now.angular_velocity - before[b].angular_velocity -
                   close[b].torque / moment_of_inertia(type.beads[b])};
  }
}

}  // namespace

void CoupledSystem::step() {
  ++progress_.steps_done;  // the new number is valid at the end of this step
  advance_fluid();

  // Beads: sends the impulses to the owners of the swimmers. The owners advance the swimmers and send the
  // beads to the ranks near them.
  std::map<BeadName, Impulse> impulses;
  record_faults([&] {
    impulses = exchange_.collect(beads_);
    add_pending_impulses(impulses);
  });
  pending_impulses_.clear();
  if_state_is_finite([&] { advance_swimmers(impulses); });
  std::swap(beads_before_, beads_);
  beads_ = exchange_.publish(owned_);

  // Transfers the momentum of cells that beads have covered or uncovered. Prepares links (or, with psm,
  // saturated cells) and close pairs for the next step.
  if_state_is_finite([&] {
    coverage_.update(beads_);
    if (has_links())
      links_.transfer_changed_cells(levels_.finest().populations, coverage_, beads_before_, beads_);
    find_links_and_contacts();
  });
  balance_net_force();
}

/// Applies the boundary conditions at halo, walls and beads, then streams and collides, row by row.
void CoupledSystem::advance_fluid() {
  Populations& fluid = levels_.finest().populations;
  saturated_cells_.begin_step(progress_.body_force);
  levels_.step(progress_.body_force, [&](int y, int z) {
    if (y > 0 && has_links()) return;
    if_state_is_finite([&] {
      has_links() ? links_.bounce_back_before_plane(fluid, coverage_, beads_, z)
                  : saturated_cells_.apply_forces_before_row(fluid, beads_, y, z);
    });
  });
  if_state_is_finite([&] {
    links_.transfer_impulses(beads_);
    saturated_cells_.transfer_impulses(beads_);
    if (has_links()) add_body_force_on_beads();
  });
}

void CoupledSystem::advance_swimmers(const std::map<BeadName, Impulse>& impulses) {
  for (SwimmerState& swimmer : owned_) {
    // Uses the mean of the impulses of two successive steps, because the impulses of half-way bounce-back
    // alternate from step to step (Ladd 1994).
    const int beads = static_cast<int>(swimmer.motion.size());
    SwimmerLoads loads(beads), close(beads);
    Eigen::Matrix3d stress = Eigen::Matrix3d::Zero();
    for (int b = 0; b < beads; ++b) {
      const Impulse& received = impulses.at({swimmer.id, b});
      Load impulse = received.fluid.value();
      add_change(impulse, swimmer.inner_momentum[b], received.inner.value());
      close[b] = received.close.value();
      loads[b].force = 0.5 * (swimmer.last_impulse[b].force + impulse.force);
      loads[b].torque = 0.5 * (swimmer.last_impulse[b].torque + impulse.torque);
      swimmer.last_impulse[b] = impulse;
      swimmer.fluid_impulse[b] += loads[b].force;
      stress += received.stress.value();
      swimmer.removed_fraction[b] = received.removed_fraction.value();
      // The links return a part of the fluid mass that the bead holds, in proportion to w_i.
      swimmer.held_mass[b] += received.mass.value();
      swimmer.mass_source[b] = returned_mass(swimmer.held_mass[b], received.link_weight.value());
    }
    const SwimmerType& type = scene_.types[swimmer.type];
    add_swimmer_contact_impulses(near_contact_, type, swimmer, close);
    for (int b = 0; b < beads; ++b) {
      loads[b].force += close[b].force;
      loads[b].torque += close[b].torque;
    }
    const SwimmerMotion before = swimmer.motion;
    advance_swimmer(swimmer.motion, type, swimmer.orientation_at_start(), loads,
                    static_cast<double>(progress_.steps_done - 1), 1, substeps_[swimmer.type]);
    if (std::optional<Fault> fault = fault_of(swimmer)) {
      record_fault(*fault);
      swimmer.motion = before;  // keeps positions valid until all ranks stop, some steps later
    }
    predict(swimmer, before, close, type);
    for (int b = 0; b < beads; ++b) close[b].force -= loads[b].force;
    add_dipole(swimmer, before, close, stress);
    if (has_net_force_) add_driving_impulse(swimmer.motion, before, loads, type);
  }
}

/// Adds the force dipole of a step (swimmers/force_dipole.hpp). reactions: the impulses of the fluid on the
/// beads, with the opposite sign; stress: sum over the beads of their stresses by these impulses. Fluid fills
/// the beads: the force on it also accelerates the fluid that a bead displaces.
void CoupledSystem::add_dipole(SwimmerState& swimmer, const SwimmerMotion& before,
                               const SwimmerLoads& reactions, const Eigen::Matrix3d& stress) const {
  BeadVectors positions(3, std::ssize(before)), forces = positions;
  for (std::size_t b = 0; b < before.size(); ++b) {
    const Bead& bead = scene_.types[swimmer.type].beads[b];
    const BeadMotion& now = swimmer.motion[b];
    positions.col(b) = (before[b].position + now.position) / 2;
    forces.col(b) =
        reactions[b].force + (mass(bead) - excess_mass(bead)) * (now.velocity - before[b].velocity);
  }
  const SymmetricTensor dipole = components_of(dipole_of_forces(positions, forces) - stress);
  for (std::size_t n = 0; n < dipole.size(); ++n) swimmer.dipole_sum[n] += dipole[n];
}

/// Adds the impulse of the driving forces on a swimmer in this step: the change of its momentum that the
/// loads do not explain.
void CoupledSystem::add_driving_impulse(const SwimmerMotion& now, const SwimmerMotion& before,
                                        const SwimmerLoads& loads, const SwimmerType& type) {
  for (std::size_t b = 0; b < now.size(); ++b) {
    const Vec3 gained = mass(type.beads[b]) * (now[b].velocity - before[b].velocity);
    driving_impulse_.add({.momentum = gained - loads[b].force});
  }
}

void CoupledSystem::balance_net_force() {
  if (!has_net_force_) return;
  constexpr double removed_part = 0.1;  // of the momentum, in one step
  // Momentum of fluid and beads without the fluid, whose momentum is progress_.unbalanced - bead_totals().
  FluidTotals without_fluid;
  if_state_is_finite([&] {
    without_fluid = volume_of_beads();
    without_fluid.add(excess_totals());
    without_fluid.subtract(bead_totals());
  });
  const Vec3 impulse = sum_over_ranks(driving_impulse_, communicator_).momentum_value();
  const Vec3 rest = sum_over_ranks(without_fluid, communicator_).momentum_value() - levels_.half_impulse();
  driving_impulse_ = {};
  const double volume = scene_.cells.cast<double>().prod();
  for (int a = 0; a < 3; ++a) {
    if (scene_.boundary[a] != Boundary::periodic) continue;
    progress_.unbalanced[a] += impulse[a] + volume * progress_.body_force[a];
    progress_.body_force[a] = -(impulse[a] + removed_part * (progress_.unbalanced[a] + rest[a])) / volume;
  }
}

void CoupledSystem::add_body_force_on_beads() {
  const Vec3 acted = levels_.body_impulses().back().acted;
  if (acted == Vec3::Zero()) return;
  coverage_.for_each_own_covered_cell(
      [&](std::ptrdiff_t, int bead, const Vec3&) { beads_[bead].impulse.fluid.add(acted, Vec3::Zero()); });
}

void CoupledSystem::find_links_or_saturated_cells() {
  has_links() ? links_.find(coverage_) : saturated_cells_.find(beads_);
}

void CoupledSystem::find_links_and_contacts() {
  find_links_or_saturated_cells();
  const CloseBeads close = add_contact_impulses(near_contact_, coverage_, beads_);
  if (!fault_) progress_.smallest_gap = std::min(progress_.smallest_gap, close.smallest_gap);
  if (close.overlap) record_fault(*close.overlap);
}

}  // namespace beadswim
