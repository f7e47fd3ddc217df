#pragma once

#include <Eigen/Core>

#include "beadswim/theory/inertial_motion.hpp"
#include "beadswim/theory/question.hpp"

// Contribution of sound to the flow around three beads on a line, in a slightly compressible fluid. Forces f
// along x that vary as exp(i omega t) cause a longitudinal flow in addition to the incompressible one:
//
//   u(k) = (k_x/k)^2 i omega / (rho (c^2 k^2 - omega^2 + 2 i omega nu k^2)) f(k)
//
//   k        wavevector of the box [1/length];  k_x its component along the swimmer
//   c        speed of sound [length/time];  rho, nu density and kinematic viscosity of the fluid
//
// Beads are spherical shells of radius a with the form factor sin(ka)/(ka). Free-slip walls are mirrors. The
// flow vanishes as 1/c^2 for large c. Page: docs/method/lattice-lag.md.

namespace beadswim {

/// Flow by sound per force, and its derivative with respect to the position of the receiving bead.
struct SoundFlow {
  Eigen::Matrix3cd value;        ///< (j, i): velocity of bead j per force on bead i [time/mass]
  Eigen::Matrix3cd by_receiver;  ///< derivative with respect to x_j [time/(mass length)]
};

/// Returns the flow in the box `place`, or in open space if `place` is nullopt; then elements off the
/// diagonal are zero. The sum includes k up to 6/(smallest radius), and at most the 2 10^5 longest waves. The
/// diagonal elements are corrected for the omitted waves.
SoundFlow sound_flow(const InertialScene& scene, const std::optional<BoxPlace>& place, double sound_speed);

}  // namespace beadswim
