#pragma once

#include "beadswim/swimmers/swimmer_dynamics.hpp"
#include "beadswim/coupling/bead_on_lattice.hpp"

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
};

}  // namespace beadswim
