#pragma once

#include <optional>
#include <vector>

#include "beadswim/theory/shaped_swimmer.hpp"

namespace beadswim {

/// Positions and velocities of the beads at equal intervals of one period, from time 0 to the end.
struct ShapeCycle {
  std::vector<BeadVectors> beads, velocities;
  /// Upper bound of the error of positions because the equations of steps are solved, and periodicity is
  /// reached, approximately [length].
  double error = 0;
};

/// Returns the motion over one period from `start`, by the implicit Runge-Kutta method Radau IIA of order 5
/// with `steps` steps (Hairer and Wanner, Solving Ordinary Differential Equations II (1996), section IV.8).
/// Returns nothing if the equations of a step cannot be solved; shorter steps may help.
std::optional<ShapeCycle> integrate_cycle(const ShapedSwimmer& swimmer, const ShapeMobility& mobility,
                                          const BeadVectors& start, int steps);

}  // namespace beadswim
