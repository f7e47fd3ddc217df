#pragma once

#include "beadswim/coupling/bead_on_lattice.hpp"
#include "beadswim/swimmers/swimmer_dynamics.hpp"

namespace beadswim {

/// All that moves of one swimmer, kept by the one rank that owns it.
struct SwimmerState {
  int id = 0;
  int type = 0;  ///< index into CoupledScene::types
  Vec3 initial_axis = Vec3::UnitX();
  SwimmerMotion motion;
  std::array<double, 3> held_mass{};    ///< of fluid that covered cells had over density 1, to be returned
  std::array<double, 3> mass_source{};  ///< BeadOnLattice::mass_source of the coming step
  SwimmerLoads last_impulse;            ///< handed over by the fluid in the step before
  SwimmerLoads inner_momentum;          ///< of fluid within the beads, where there is (saturated_cells.hpp)
  std::array<BeadVelocity, 3> predicted{};  ///< BeadOnLattice::predicted of the coming step
  std::array<double, 3> firmness{};         ///< BeadOnLattice::firmness

  static void visit_fields(auto&& visit, auto& swimmer) {
    visit("id", swimmer.id);
    visit("type", swimmer.type);
    visit("initial_axis", swimmer.initial_axis);
    visit_bead_fields(visit, swimmer);
  }

  /// Visits the fields of which each bead has one. They are the state of the beads, which state_sha256()
  /// hashes.
  static void visit_bead_fields(auto&& visit, auto& swimmer) {
    visit("held_mass", swimmer.held_mass);
    visit("mass_source", swimmer.mass_source);
    visit("firmness", swimmer.firmness);
    visit("motion", swimmer.motion);
    visit("last_impulse", swimmer.last_impulse);
    visit("inner_momentum", swimmer.inner_momentum);
    visit("predicted", swimmer.predicted);
  }
};

}  // namespace beadswim
