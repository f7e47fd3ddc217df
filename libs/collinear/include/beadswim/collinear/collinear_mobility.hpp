#pragma once

#include <Eigen/Core>
#include <array>

#include "beadswim/collinear/pair_mobility.hpp"

namespace beadswim {

/// Positions of the centres of three spheres along their line, x_1 < x_2 < x_3 [length].
using LinePositions = std::array<double, 3>;

/// Mobility matrix mu of three spheres on a line, and its derivatives by the positions x_k of the spheres.
/// For the forces F on the spheres along the line, the velocities along the line are v = mu F. v and F are
/// positive in the direction from sphere 1 to sphere 3.
struct CollinearMobility {
  Eigen::Matrix3d value;                 ///< mu [time/mass], symmetric
  std::array<Eigen::Matrix3d, 3> slope;  ///< d mu / d x_k [time/(mass length)]; sum over k is 0 in open space
  /// Axial stresslet of all spheres per force on each [length], and column k: its derivative by x_k [1].
  /// Zero for pair mobilities.
  Eigen::Vector3d stresslet = Eigen::Vector3d::Zero();
  Eigen::Matrix3d stresslet_slope = Eigen::Matrix3d::Zero();
};

/// Returns the mobility matrix mu of three spheres on a line, and its derivatives by the positions. The
/// element of two spheres is the pair mobility `law`, evaluated as if the third sphere were absent. The
/// diagonal elements are the Stokes mobilities of lone spheres. Radii and positions are in [length], the
/// dynamic viscosity in [mass/(length time)].
CollinearMobility pairwise_mobility(PairLaw law, const std::array<double, 3>& radii,
                                    const LinePositions& positions, double viscosity);

}  // namespace beadswim
