#pragma once

#include <Eigen/Core>
#include <complex>
#include <optional>

#include "beadswim/theory/inertial_motion.hpp"
#include "beadswim/theory/question.hpp"

// Errors that finite time steps cause in a lattice-Boltzmann run, even on arbitrarily fine cells. Viscous
// stress and the forces of the fluid on beads are delayed, and pressure propagates with the speed of sound.
// The errors are evaluated to first order in the time step. The theory of motion with inertia
// (inertial_motion.hpp) is used with three changes: of the dynamic viscosity eta of the fluid, of the induced
// mobility M (velocities of the beads per force that the beads exert on the fluid), and of the equation of
// motion of a bead.
//
//   eta -> eta (1 - i omega t_s)            stress lags strain by t_s = nu/c^2 = (tau - 1/2) steps
//   M -> M + sound_flow                     with the changed eta in M; sound_flow(): below
//   F = e^{-i omega step} (M^-1 - i omega m_f) U + i omega (m + zeta t_d) U
//
//   omega    driving frequency [rad/time];  nu  kinematic viscosity [length^2/time];  tau  relaxation time
//   c        = cell/(sqrt(3) step), speed of sound of the lattice [length/time]
//   step     time step [time]: the force of the fluid acts on a bead one step late, hence e^{-i omega step}
//   F, U     force of driving, springs and dashpots on a bead, and its velocity: complex amplitudes
//   m, m_f   mass of the bead, mass of the fluid that it displaces [mass]
//   t_d      = 3/2 t_s + step, delay of the force of the fluid [time]. The delay correction compensates it by
//            the added mass zeta t_d; without this correction the last term has no t_d.
//   zeta     = 6 pi eta a, a: bead radius [mass/time]
//
// Page: docs/method/lattice-lag.md.

namespace beadswim {

/// Time step and speed of sound of a lattice run.
struct LatticeTiming {
  double step = 0;             ///< time step [time]
  double sound_speed = 0;      ///< cell/(sqrt(3) step) [length/time]
  bool corrects_delay = true;  ///< true: beads have added mass, which compensates the delay of forces
};

/// Values of the velocity of a swimmer and of its two arm amplitudes, in this order: the quantities
/// themselves [length/time, length], or their relative errors.
using MotionValues = Eigen::Array3d;

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
// flow vanishes as 1/c^2 for large c.

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

/// Evaluates the errors of one swimmer for any time step. The constructor computes all quantities that do not
/// depend on the step. In open space, the effect of sound is evaluated for each bead alone; sound from other
/// beads is neglected.
class LatticeLag {
 public:
  explicit LatticeLag(const Question& question);

  /// Returns the relative errors of a run with these time steps. Those of arm amplitudes are positive if the
  /// amplitude of the run is too large. The velocity has two parts, which have separate errors: that by the
  /// mean Reynolds stress of the fluid, and the drift by the displacements of the beads. Its error is the sum
  /// of the magnitudes of both.
  MotionValues errors(const LatticeTiming& timing) const;

 private:
  /// Values of a matrix at the driving frequency omega, and at a slightly lower and a slightly higher
  /// frequency. The matrix is a function of omega rho/eta, divided by eta, where rho is the density and eta
  /// the dynamic viscosity of the fluid. Its change with eta therefore follows from its change with omega.
  struct FrequencySamples {
    Eigen::Matrix3cd at, below, above;

    /// Returns the matrix for the viscosity eta (1 - eps) in place of eta, to first order in eps.
    Eigen::Matrix3cd with_delayed_stress(std::complex<double> eps) const;
  };
  struct Motion {
    Eigen::Vector2cd arm;
    double drift = 0, reynolds = 0;
  };

  template <class Flow>
  FrequencySamples frequency_samples(const Flow& flow) const;
  Motion motion(const Eigen::Matrix3cd& mobility, const Eigen::Matrix3cd& induced,
                const DriftForm& form) const;
  Eigen::Matrix3cd with_delayed_links(const Eigen::Matrix3cd& induced, const LatticeTiming& timing) const;

  InertialScene scene_;
  std::optional<BoxPlace> box_;
  FrequencySamples induced_, slopes_;
  DriftForm form_;
  Eigen::Matrix3cd reynolds_;
  Motion exact_;
};

}  // namespace beadswim
