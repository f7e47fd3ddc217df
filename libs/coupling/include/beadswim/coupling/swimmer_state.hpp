#pragma once

#include "beadswim/bodies/swimmer_dynamics.hpp"

namespace beadswim {

/// All that moves of one swimmer, kept by the one rank that owns it.
struct SwimmerState {
  int id = 0;
  int type = 0;  ///< index into CoupledScene::types
  Vec3 initial_axis = Vec3::UnitX();
  SwimmerMotion motion;
  SwimmerLoads last_impulse;  ///< handed over by the fluid in the step before
};

}  // namespace beadswim
