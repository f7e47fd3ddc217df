#pragma once

#include <optional>
#include <vector>

#include "beadswim/core/vec3.hpp"
#include "beadswim/mobility/mobility_product.hpp"
#include "beadswim/scene/placed_swimmers.hpp"

namespace beadswim {

/// One vector per bead, in order of the swimmers.
using Beads = std::vector<Vec3>;

/// A swarm without inertia, its fluid and its time step, in any coherent unit system.
struct OverdampedScene : Swarm {
  MobilityModel model = MobilityModel::rpy;
  int moment_order = 0;  ///< models multipole and unsteady: highest moment of the force on each bead, 0 to 2
  double viscosity = 0;  ///< dynamic viscosity eta of the fluid [mass/(length time)]
  std::optional<Box> box;  ///< box of the fluid; no value means unbounded fluid
  std::optional<HalfSpace> half_space;
  BackgroundFlow flow;
  double step = 0;  ///< time step [time]
  /// Largest relative error of the velocities that the mobility product returns. The linear solver of a time
  /// step stops at a relative error of 0.3 times this value.
  double tolerance = 1e-4;
  std::optional<FluidMemory> memory;  ///< model unsteady
};

/// Returns the mass of a bead minus the mass of the fluid that it displaces.
double excess_mass(const Bead& bead, double fluid_density);

/// Returns for each bead its mass minus the mass of the fluid that it displaces; empty without memory of the
/// fluid.
std::vector<double> excess_masses(const OverdampedScene& scene);

/// Returns the input of the mobility product for all beads of the scene.
MobilityScene mobility_scene(const OverdampedScene& scene);

}  // namespace beadswim
