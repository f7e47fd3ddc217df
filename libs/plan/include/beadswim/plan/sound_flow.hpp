#pragma once

#include <Eigen/Core>

#include "beadswim/theory/inertial_motion.hpp"
#include "beadswim/theory/question.hpp"

// Contribution of sound to the flow around three beads on a line, in a slightly compressible fluid. Forces f
// along x that vary as exp(i omega t) cause a longitudinal flow u in addition to the incompressible flow. For
// the Fourier components with wavevector k,
//
//   u(k) = (k_x/k)^2 i omega / (rho (c^2 k^2 - omega^2 + 2 i omega nu k^2)) f(k)
//
//   k        wavevector of the box [1/length];  k_x its component along x, the axis of the swimmer
//   omega    angular frequency [rad/time];  c  speed of sound [length/time]
//   rho, nu  density [mass/length^3] and kinematic viscosity [length^2/time] of the fluid
//
// Beads are spherical shells of radius a with the form factor sin(ka)/(ka). Free-slip walls are mirrors. The
// flow vanishes as 1/c^2 for large c. Page: docs/method/lattice-lag.md.

namespace beadswim {

/// Velocities of the flow by sound at the beads, per force on the beads, and their derivatives.
struct SoundFlow {
  Eigen::Matrix3cd value;        ///< element (j, i): velocity of bead j per force on bead i [time/mass]
  Eigen::Matrix3cd by_receiver;  ///< derivative of value(j, i) by position x_j of bead j [time/(mass length)]
};

/// Returns the flow by sound in the box `place`, or in open space if `place` is nullopt. In open space the
/// off-diagonal elements are zero, because sound from other beads is neglected. In a box the flow is a sum
/// over the wavevectors k with |k| up to 6/(smallest radius), but at most over the 2 x 10^5 wavevectors with
/// the smallest |k|. The waves with larger |k| are added to the diagonal elements as an integral.
/// sound_speed: [length/time].
SoundFlow sound_flow(const InertialScene& scene, const std::optional<BoxPlace>& place, double sound_speed);

}  // namespace beadswim
