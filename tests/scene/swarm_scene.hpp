#pragma once

#include "beadswim/scene/presets.hpp"
#include "beadswim/scene/swarm.hpp"

namespace beadswim {

/// Returns the swarm of a plan in its periodic box as a layout.
inline Layout swarm_of(const SwarmPlan& plan, const SwimmerType& type) {
  Layout layout = paper_swarm();
  layout.types["a"] = type;
  layout.domain.box = swarm_box(plan, type);
  layout.swimmers = swarm_swimmers(plan, type, "a");
  return layout;
}

}  // namespace beadswim
