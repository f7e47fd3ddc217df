#pragma once

#include <optional>
#include <vector>

#include "beadswim/core/vec3.hpp"
#include "beadswim/mobility/mobility_product.hpp"
#include "beadswim/scene/placed_swimmers.hpp"

namespace beadswim {

/// One vector per bead, three beads per swimmer, in order of the swimmers.
using Beads = std::vector<Vec3>;

/// A swarm without inertia. Any coherent unit system.
struct OverdampedScene : Swarm {
  MobilityModel model = MobilityModel::rpy;
  double viscosity = 0;     ///< dynamic, eta [mass/(length time)]
  std::optional<Box> box;   ///< none: open space
  double step = 0;          ///< time step [time]
  double tolerance = 1e-4;  ///< tolerance of the mobility product; the linear solver uses 0.3 of it
};

}  // namespace beadswim
