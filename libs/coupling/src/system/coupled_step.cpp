#include <algorithm>
#include <utility>

#include "beadswim/coupling/bead_boundary.hpp"
#include "beadswim/coupling/coupled_system.hpp"
#include "beadswim/coupling/saturated_boundary.hpp"
#include "beadswim/lattice/fluid_step.hpp"

// The method, step by step. Populations are kept as they are after collision at time n; a step takes fluid
// and beads from n to n + 1. See docs/method/momentum-exchange.md, staircase-beads.md,
// interpolated-beads.md, multireflection.md, saturated-cells.md.

namespace beadswim {
namespace {

/// Fluid within a bead moves with it, but its inertia is not the bead's: what sets it in motion is no load.
void add_change(Load& impulse, Load& inner, const Load& inner_now) {
  impulse.force += inner_now.force - inner.force;
  impulse.torque += inner_now.torque - inner.torque;
  inner = inner_now;
}

/// Velocities at the end of the coming step, if no bead were close: as they are, and once more what this step
/// has changed without the impulses of close beads.
void predict(SwimmerState& swimmer, const SwimmerMotion& before, const SwimmerLoads& close,
             const SwimmerType& type) {
  for (int b = 0; b < 3; ++b) {
    const BeadMotion& now = swimmer.motion[b];
    swimmer.predicted[b] = {
        .linear = 2 * now.velocity - before[b].velocity - close[b].force / mass(type.beads[b]),
        .angular = 2 * now.angular_velocity - before[b].angular_velocity -
                   close[b].torque / moment_of_inertia(type.beads[b])};
  }
}

}  // namespace

void CoupledSystem::step() {
  ++steps_done_;  // by the end of it
  // Fluid: what streams in from neighbours, walls and beads, then streaming and collision, row by row.
  if (has_links(scene_.bead_boundary)) {
    step_fluid_with_links();
  } else {
    step_fluid_with_saturated_cells();
  }

  // Beads: impulses go to the swimmers' owners, who move them and tell where they are.
  std::map<BeadName, Impulse> impulses;
  noting_faults([&] {
    impulses = exchange_.collect(beads_);
    add_under_way(impulses);
  });
  under_way_.clear();
  unless_broken([&] { advance_swimmers(impulses); });
  std::swap(beads_before_, beads_);
  beads_ = exchange_.publish(owned_);

  // Cells that changed hands, and where beads meet the fluid and each other in the next step.
  unless_broken([&] {
    coverage_.update(beads_);
    if (has_links(scene_.bead_boundary))
      hand_over_changed_cells(populations_, coverage_, links_, beads_before_, beads_, rates_);
    meet();
  });
}

void CoupledSystem::step_fluid_with_links() {
  link_sums_.resize(beads_.size());
  BeadBoundary boundary{coverage_, links_, beads_, rates_, link_sums_};
  step_fluid(populations_, halo_, rates_, [&](int y, int z) {
    unless_broken([&] { boundary.bounce_back_before_row(populations_, y, z); });
  });
  unless_broken([&] { hand_over_impulses(link_sums_, beads_); });
}

void CoupledSystem::step_fluid_with_saturated_cells() {
  saturated_sums_.resize(beads_.size());
  SaturatedBoundary boundary{saturated_cells_, beads_, saturated_sums_,
                             lattice_viscosity(scene_.relaxation_time)};
  step_fluid(populations_, halo_, rates_,
             [&](int y, int z) { unless_broken([&] { boundary.push_before_row(populations_, y, z); }); });
  unless_broken([&] { hand_over_impulses(saturated_sums_, beads_); });
}

void CoupledSystem::advance_swimmers(const std::map<BeadName, Impulse>& impulses) {
  for (SwimmerState& swimmer : owned_) {
    // The mean of two steps' impulses: a staircase answers alternate steps differently (Ladd 1994).
    SwimmerLoads loads;
    SwimmerLoads close;
    for (int b = 0; b < 3; ++b) {
      const Impulse& handed = impulses.at({swimmer.id, b});
      Load impulse = handed.value();
      add_change(impulse, swimmer.inner_momentum[b], handed.inner_value());
      close[b] = handed.close_value();
      loads[b].force = 0.5 * (swimmer.last_impulse[b].force + impulse.force);
      loads[b].torque = 0.5 * (swimmer.last_impulse[b].torque + impulse.torque);
      swimmer.last_impulse[b] = impulse;
      swimmer.firmness[b] = handed.firmness.value();
      // Its links return a part of the fluid mass that it has come to hold, alike in all directions.
      swimmer.held_mass[b] += handed.mass.value();
      swimmer.mass_source[b] = returned_mass(swimmer.held_mass[b], handed.link_weight.value());
    }
    const SwimmerType& type = scene_.types[swimmer.type];
    push_chain(near_contact_, type, swimmer, close);
    for (int b = 0; b < 3; ++b) {
      loads[b].force += close[b].force;
      loads[b].torque += close[b].torque;
    }
    const SwimmerMotion before = swimmer.motion;
    advance_swimmer(swimmer.motion, type, swimmer.initial_axis, loads, static_cast<double>(steps_done_ - 1),
                    1, substeps_[swimmer.type]);
    if (std::optional<Fault> fault = fault_of(swimmer)) {
      note(*fault);
      swimmer.motion = before;  // ranks agree to stop within some steps, results intact
    }
    predict(swimmer, before, close, type);
  }
}

void CoupledSystem::find_surfaces() {
  if (has_links(scene_.bead_boundary)) {
    links_.find(coverage_);
  } else {
    saturated_cells_.find(beads_);
  }
}

void CoupledSystem::meet() {
  find_surfaces();
  const CloseBeads close = push_close_beads(near_contact_, coverage_, beads_);
  if (!fault_) smallest_gap_ = std::min(smallest_gap_, close.smallest_gap);
  if (close.overlap) note(*close.overlap);
}

}  // namespace beadswim
