#pragma once

#include <Eigen/Core>
#include <array>

#include "beadswim/mobility/pair_mobility.hpp"

namespace beadswim {

/// Mobility of three spheres on a line, and how it changes with the two arms (centre distances) between them:
/// v = value F for the bead velocities v and the forces F along the line, both positive from bead 1 to
/// bead 3.
struct CollinearMobility {
  Eigen::Matrix3d value;                 ///< mu [time/mass], symmetric
  std::array<Eigen::Matrix3d, 2> slope;  ///< d mu / d L_1 and d mu / d L_2 [time/(mass length)]
};

/// The mobility of three spheres whose pairs interact by `law`; beads 1 and 3 are L_1 + L_2 apart.
/// Radii and arms [length], viscosity is dynamic [mass/(length time)]. Spheres must not overlap.
CollinearMobility pairwise_mobility(PairLaw law, const std::array<double, 3>& radii,
                                    const std::array<double, 2>& arms, double viscosity);

}  // namespace beadswim
