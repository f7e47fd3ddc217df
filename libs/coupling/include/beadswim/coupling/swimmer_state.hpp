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
  std::array<double, 3> held_mass{};  ///< fluid mass above density 1 from covered cells, still to be returned
  std::array<double, 3> mass_source{};       ///< BeadOnLattice::mass_source of the next step
  SwimmerLoads last_impulse;                 ///< by the fluid in the previous step
  SwimmerLoads inner_momentum;               ///< of the fluid within the beads (psm, saturated_cells.hpp)
  std::array<BeadVelocity, 3> predicted{};   ///< BeadOnLattice::predicted of the next step
  std::array<double, 3> removed_fraction{};  ///< BeadOnLattice::removed_fraction

  static void visit_fields(auto&& visit, auto& swimmer) {
    visit("id", swimmer.id);
    visit("type", swimmer.type);
    visit("initial_axis", swimmer.initial_axis);
    visit_bead_fields(visit, swimmer);
  }

  /// Visits the fields with one entry per bead. They are the state of the beads that state_sha256() hashes.
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
