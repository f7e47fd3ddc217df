#pragma once

#include <Eigen/Core>
#include <array>

#include "beadswim/mobility/pair_mobility.hpp"

namespace beadswim {

/// Positions of the centres of three spheres along their line, x_1 < x_2 < x_3 [length].
using LinePositions = std::array<double, 3>;

/// Mobility matrix mu of three spheres on a line, and its derivatives by the positions. It gives the
/// velocities v = mu F along the line for forces F along the line. v and F are positive in the direction from
/// sphere 1 to sphere 3.
struct CollinearMobility {
  Eigen::Matrix3d value;                 ///< mu [time/mass], symmetric
  std::array<Eigen::Matrix3d, 3> slope;  ///< d mu / d x_k [time/(mass length)]; sum over k is 0 in open space
};

/// Returns the mobility of three spheres. Each pair interacts by `law`, independently of the third sphere.
/// Radii and positions are in [length], the dynamic viscosity in [mass/(length time)].
CollinearMobility pairwise_mobility(PairLaw law, const std::array<double, 3>& radii,
                                    const LinePositions& positions, double viscosity);

}  // namespace beadswim
