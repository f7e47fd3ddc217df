#pragma once

#include <optional>
#include <vector>

#include "beadswim/core/vec3.hpp"
#include "beadswim/mobility/mobility_product.hpp"
#include "beadswim/scene/placed_swimmers.hpp"

namespace beadswim {

/// Vectors of all beads, three a swimmer, in order of the swimmers.
using Beads = std::vector<Vec3>;

/// A swarm without inertia. Any coherent unit system.
struct OverdampedScene : Swarm {
  MobilityModel model = MobilityModel::rpy;
  double viscosity = 0;     ///< dynamic
  std::optional<Box> box;   ///< none: open space
  double step = 0;          ///< [time]
  double tolerance = 1e-4;  ///< of the mobility product; a third of it of the step's solution
};

}  // namespace beadswim
