#pragma once

#include <Eigen/Core>
#include <array>

#include "beadswim/mobility/pair_mobility.hpp"

namespace beadswim {

/// Places of three spheres' centres along their line, x_1 < x_2 < x_3 [length].
using LinePositions = std::array<double, 3>;

/// Mobility of three spheres on a line, and how it changes with their places: v = value F for the bead
/// velocities v and the forces F along the line, both positive from bead 1 to bead 3.
struct CollinearMobility {
  Eigen::Matrix3d value;                 ///< mu [time/mass], symmetric
  std::array<Eigen::Matrix3d, 3> slope;  ///< d mu / d x_k [time/(mass length)]; their sum is 0 in open space
};

/// The mobility of three spheres whose pairs interact by `law`. Radii and positions [length], viscosity is
/// dynamic [mass/(length time)].
CollinearMobility pairwise_mobility(PairLaw law, const std::array<double, 3>& radii,
                                    const LinePositions& positions, double viscosity);

}  // namespace beadswim
