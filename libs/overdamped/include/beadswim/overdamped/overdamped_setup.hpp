#pragma once

#include <string>

#include "beadswim/overdamped/overdamped_scene.hpp"
#include "beadswim/scene/layout.hpp"

namespace beadswim {

/// Accuracy of a run with a mobility model.
struct MobilitySettings {
  double tolerance =
      1e-4;  ///< error of velocities by the mobility product, relative to their root mean square
  int steps_per_cycle = 100;  ///< time steps per shortest period of the swimmers' driving
};

/// The scene of a layout for a mobility model, with its time steps.
struct OverdampedSetup {
  OverdampedScene scene;
  double base_period = 0;    ///< [time]
  long steps_per_cycle = 0;  ///< time steps per base period
};

/// Converts a layout. Throws InputError if the layout has no-slip walls or if its box is too narrow. `source`
/// is the name of the layout in messages.
OverdampedSetup overdamped_setup(const Layout& layout, MobilityModel model, const MobilitySettings& settings,
                                 const std::string& source);

}  // namespace beadswim
