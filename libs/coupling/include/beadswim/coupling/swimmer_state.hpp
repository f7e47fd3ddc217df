#pragma once

#include "beadswim/coupling/bead_on_lattice.hpp"
#include "beadswim/swimmers/swimmer_dynamics.hpp"

namespace beadswim {

/// State of one swimmer, kept by the rank that owns it, in lattice units.
struct SwimmerState {
  int id = 0;
  int type = 0;  ///< index into CoupledScene::types
  Vec3 initial_axis = Vec3::UnitX();
  SwimmerMotion motion;
  /// Excess mass (density - 1) of fluid that each bead has covered and not yet returned through its links.
  std::array<double, 3> held_mass{};
  /// Fluid mass that each link of a bead returns in the next step, divided by the weight of the link.
  std::array<double, 3> mass_source{};
  SwimmerLoads last_impulse;    ///< impulses of the fluid on the beads in the previous step
  SwimmerLoads inner_momentum;  ///< momenta of the fluid within the beads (psm, saturated_cells.hpp)
  std::array<BeadVelocity, 3> predicted{};   ///< velocities at the end of the next step without close beads
  std::array<double, 3> removed_fraction{};  ///< Impulse::removed_fraction of the beads in the last step

  static void visit_fields(auto&& visit, auto& swimmer) {
    visit("id", swimmer.id);
    visit("type", swimmer.type);
    visit("initial_axis", swimmer.initial_axis);
    visit_bead_fields(visit, swimmer);
  }

  /// Visits the fields with one entry per bead. state_sha256() hashes these fields.
  static void visit_bead_fields(auto&& visit, auto& swimmer) {
    visit("held_mass", swimmer.held_mass);
    visit("mass_source", swimmer.mass_source);
    visit("removed_fraction", swimmer.removed_fraction);
    visit("motion", swimmer.motion);
    visit("last_impulse", swimmer.last_impulse);
    visit("inner_momentum", swimmer.inner_momentum);
    visit("predicted", swimmer.predicted);
  }
};

}  // namespace beadswim
