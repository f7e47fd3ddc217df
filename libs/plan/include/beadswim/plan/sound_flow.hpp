#pragma once

#include <Eigen/Core>

#include "beadswim/theory/inertial_motion.hpp"
#include "beadswim/theory/question.hpp"

// What sound adds to the flow between three beads on a line, exp(i omega t), in a fluid that is a little
// compressible. Forces along x also push the fluid along its gradients:
//
//   u(k) = (k_x/k)^2 i omega / (rho (c^2 k^2 - omega^2 + 2 i omega nu k^2)) f(k)      c: speed of sound
//
// summed over the waves of the box, the beads seen as shells, sin(ka)/(ka). Free-slip walls are mirrors.
// As c grows it vanishes, like 1/c^2. Page: docs/method/lattice-lag.md.

namespace beadswim {

struct SoundFlow {
  Eigen::Matrix3cd value;  ///< velocity of bead j by a force on bead i, (j, i), own flow too [time/mass]
  Eigen::Matrix3cd by_receiver;  ///< its slope in the place of bead j [time/(mass length)]
};

/// In the box of the scene; zero off the diagonal in open space. Waves with k over 6 by the smallest radius
/// are left out, and all but the longest 2 10^5, except of a bead's own flow.
SoundFlow sound_flow(const InertialScene& scene, const std::optional<BoxPlace>& place, double sound_speed);

}  // namespace beadswim
