#pragma once

#include <string>

#include "beadswim/overdamped/overdamped_scene.hpp"
#include "beadswim/scene/layout.hpp"

namespace beadswim {

/// Accuracy of a run by a mobility.
struct MobilitySettings {
  double tolerance = 1e-4;  ///< of bead velocities by the sum over pairs and images, relative to their r.m.s.
  int steps_per_cycle = 100;  ///< time steps in the shortest period of any swimmer's driving
};

/// A layout's scene as a mobility model runs it.
struct OverdampedSetup {
  OverdampedScene scene;
  double base_period = 0;    ///< [time]
  long steps_per_cycle = 0;  ///< time steps in the base period
};

/// Throws InputError, `source` naming the layout, if it has no-slip walls or its box is too narrow.
OverdampedSetup overdamped_setup(const Layout& layout, MobilityModel model, const MobilitySettings& settings,
                                 const std::string& source);

}  // namespace beadswim
