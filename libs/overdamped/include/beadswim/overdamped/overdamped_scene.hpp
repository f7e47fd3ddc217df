#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "beadswim/core/vec3.hpp"
#include "beadswim/mobility/mobility.hpp"
#include "beadswim/scene/placed_swimmers.hpp"

namespace beadswim {

/// One vector per bead, in order of the swimmers.
using Beads = std::vector<Vec3>;

/// A swarm without inertia, the mobility of its beads and its time step, in any coherent unit system. The
/// linear solver of a time step stops at a relative error of 0.3 times the tolerance of the mobility.
struct OverdampedScene : Swarm, MobilityScene {  // `radii` and `lines` are set by mobility_scene()
  double step = 0;                               ///< time step [time]
  double thermal_energy = 0;                     ///< kT [energy]; 0: no thermal noise
  std::uint64_t seed = 1;                        ///< of the random numbers of the noise
  double noise_tolerance = 1e-3;                 ///< accepted relative error of the noise (mobility_root.hpp)
};

/// Returns the mass of a bead minus the mass of the fluid that it displaces.
double excess_mass(const Bead& bead, double fluid_density);

/// Returns for each bead its mass minus the mass of the fluid that it displaces; empty without memory of the
/// fluid.
std::vector<double> excess_masses(const OverdampedScene& scene);

/// Returns the input of the mobility product for all beads of the scene.
MobilityScene mobility_scene(const OverdampedScene& scene);

}  // namespace beadswim
