#pragma once

#include <Eigen/Core>
#include <array>

#include "beadswim/mobility/pair_mobility.hpp"

namespace beadswim {

/// Positions of the centres of three spheres along their line, x_1 < x_2 < x_3 [length].
using LinePositions = std::array<double, 3>;

/// Mobility mu of three spheres on a line, and its derivatives by the positions. The velocities along the
/// line are v = mu F, where v and F are positive from bead 1 to bead 3.
struct CollinearMobility {
  Eigen::Matrix3d value;                 ///< mu [time/mass], symmetric
  std::array<Eigen::Matrix3d, 3> slope;  ///< d mu / d x_k [time/(mass length)]; their sum is 0 in open space
};

/// Returns the mobility of three spheres whose pairs interact by `law`. Radii and positions [length], dynamic
/// viscosity [mass/(length time)].
CollinearMobility pairwise_mobility(PairLaw law, const std::array<double, 3>& radii,
                                    const LinePositions& positions, double viscosity);

}  // namespace beadswim
