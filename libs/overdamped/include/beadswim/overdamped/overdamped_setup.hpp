#pragma once

#include <optional>
#include <string>

#include "beadswim/overdamped/overdamped_scene.hpp"
#include "beadswim/scene/unit_scales.hpp"

namespace beadswim {

/// Accuracy of a run with a mobility model.
struct MobilitySettings {
  /// Largest error of the bead velocities that the product of mobility and forces returns, divided by the
  /// root mean square of these velocities.
  double tolerance = 1e-4;
  /// Models multipole and unsteady: highest moment of the force on each bead, 0 to 2
  /// (mobility/force_moments.hpp).
  int multipole_order = 1;
  bool reynolds_stress = true;  ///< model unsteady: Reynolds stress of the flow (mobility/fluid_memory.hpp)
  /// Time steps per shortest driving period of all swimmers; nullopt: at least `default_steps_per_cycle`, so
  /// many that each frame is taken at the end of a step.
  std::optional<int> steps_per_cycle;
  std::optional<int> seed{};      ///< of the thermal noise; nullopt: that of the layout, else 1
  double noise_tolerance = 1e-3;  ///< largest relative error of the thermal noise

  static constexpr int default_steps_per_cycle = 100;
};

/// Scene made from a layout for a mobility model, and its division into time steps.
struct OverdampedSetup {
  OverdampedScene scene;     ///< in `units`
  UnitScales units;          ///< natural_units() of the layout
  double base_period = 0;    ///< period that all swimmers share, or that of the first one [time]
  long steps_per_cycle = 0;  ///< time steps per base period
};

/// Converts a layout to a scene for a mobility model. `frames_per_cycle`: number of frames that are recorded
/// per base period. `source` is the name of the layout in messages. Throws InputError in these cases:
///   - The box of the layout has no-slip walls, or an edge below 4.4 times the radius of the largest bead.
///   - The fluid has a thermal energy, and the model is oseen or unsteady, or the time steps are too long for
///     contacts against noise.
///   - The model is unsteady, and the layout has a half-space or a background flow, or radii, densities, net
///     forces or the mesh exceed the limits of this model (docs/method/fluid-memory.md).
OverdampedSetup overdamped_setup(const Layout& layout, MobilityModel model, const MobilitySettings& settings,
                                 int frames_per_cycle, const std::string& source);

/// Returns the relative error of the mobility of one sphere over a plane no-slip wall, at this height over
/// its radius: across the wall, where it is largest, and along it with rpy+near.
double error_near_wall(double height, MobilityModel model, const MobilitySettings& settings);

}  // namespace beadswim
