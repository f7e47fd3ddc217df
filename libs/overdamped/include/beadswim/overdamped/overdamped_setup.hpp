#pragma once

#include <string>

#include "beadswim/overdamped/overdamped_scene.hpp"
#include "beadswim/scene/layout.hpp"

namespace beadswim {

/// Accuracy of a run with a mobility model.
struct MobilitySettings {
  /// Error of the velocities that the mobility product gives, divided by their root mean square.
  double tolerance = 1e-4;
  int steps_per_cycle = 100;  ///< time steps per shortest driving period of all swimmers
};

/// Scene made from a layout for a mobility model, and its division into time steps.
struct OverdampedSetup {
  OverdampedScene scene;
  double base_period = 0;    ///< [time]
  long steps_per_cycle = 0;  ///< time steps per base period
};

/// Converts a layout. `source` is the name of the layout in messages. Throws InputError if the layout has
/// no-slip walls, or if an edge of its box is less than 4.4 times the largest radius.
OverdampedSetup overdamped_setup(const Layout& layout, MobilityModel model, const MobilitySettings& settings,
                                 const std::string& source);

}  // namespace beadswim
