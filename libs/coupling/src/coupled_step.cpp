#include <utility>

#include "beadswim/coupling/bead_boundary.hpp"
#include "beadswim/coupling/coupled_system.hpp"
#include "beadswim/coupling/saturated_boundary.hpp"
#include "beadswim/lattice/fluid_step.hpp"

// The method, step by step. Populations are kept as they are after collision at time n; a step takes fluid
// and beads from n to n + 1. See docs/method/staircase-beads.md and
// interpolated-beads.md, multireflection.md, saturated-cells.md.

namespace beadswim {
namespace {

/// Fluid within a bead moves with it, but its inertia is not the bead's: what sets it in motion is no load.
void add_change(Load& impulse, Load& inner, const Load& inner_now) {
  impulse.force += inner_now.force - inner.force;
  impulse.torque += inner_now.torque - inner.torque;
  inner = inner_now;
}

}  // namespace

void CoupledSystem::step() {
  // Fluid: what streams in from neighbours, walls and beads, then streaming and collision, row by row.
  const bool by_links = has_links(scene_.bead_boundary);
  if (by_links) {
    step_fluid_with_links();
  } else {
    step_fluid_with_saturated_cells();
  }

  // Beads: the fluid's impulses go to the swimmers' owners, who move them and tell where they are.
  advance_swimmers(exchange_.collect(beads_));
  std::swap(beads_before_, beads_);
  beads_ = exchange_.publish(owned_);

  // Cells that changed hands, and where beads meet the fluid now.
  coverage_.update(beads_);
  if (by_links) {
    hand_over_changed_cells(populations_, coverage_, links_, beads_before_, beads_, rates_);
    links_.find(coverage_);
  } else {
    saturated_cells_.find(beads_);
  }
  ++steps_done_;
}

void CoupledSystem::step_fluid_with_links() {
  link_sums_.resize(beads_.size());
  BeadBoundary boundary{coverage_, links_, beads_, rates_, link_sums_};
  step_fluid(populations_, halo_, rates_,
             [&](int y, int z) { boundary.bounce_back_before_row(populations_, y, z); });
  hand_over_impulses(link_sums_, beads_);
}

void CoupledSystem::step_fluid_with_saturated_cells() {
  saturated_sums_.resize(beads_.size());
  SaturatedBoundary boundary{saturated_cells_, beads_, saturated_sums_,
                             lattice_viscosity(scene_.relaxation_time)};
  step_fluid(populations_, halo_, rates_,
             [&](int y, int z) { boundary.push_before_row(populations_, y, z); });
  hand_over_impulses(saturated_sums_, beads_);
}

void CoupledSystem::advance_swimmers(const std::map<BeadName, Impulse>& impulses) {
  for (SwimmerState& swimmer : owned_) {
    // The mean of two steps' impulses: a staircase answers alternate steps differently (Ladd 1994).
    SwimmerLoads loads;
    for (int b = 0; b < 3; ++b) {
      const Impulse& from_fluid = impulses.at({swimmer.id, b});
      Load impulse = from_fluid.value();
      add_change(impulse, swimmer.inner_momentum[b], from_fluid.inner_value());
      loads[b].force = 0.5 * (swimmer.last_impulse[b].force + impulse.force);
      loads[b].torque = 0.5 * (swimmer.last_impulse[b].torque + impulse.torque);
      swimmer.last_impulse[b] = impulse;
      // Its links return a part of the fluid mass that it has come to hold, alike in all directions.
      swimmer.held_mass[b] += from_fluid.mass.value();
      const double link_weight = from_fluid.link_weight.value();
      swimmer.mass_source[b] = returned_mass(swimmer.held_mass[b], link_weight);
    }
    const SwimmerMotion before = swimmer.motion;
    advance_swimmer(swimmer.motion, scene_.types[swimmer.type], swimmer.initial_axis, loads,
                    static_cast<double>(steps_done_), 1, substeps_[swimmer.type]);
    // A bead that is too fast waits where it is: ranks agree to stop within some steps, results intact.
    if (is_too_fast(swimmer)) swimmer.motion = before;
  }
}

}  // namespace beadswim
