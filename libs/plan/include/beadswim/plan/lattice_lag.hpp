#pragma once

#include <Eigen/Core>
#include <array>
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
//   M -> M + sound_flow                     with the changed eta in M; sound_flow: sound_flow.hpp
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

/// Relative errors of arm amplitudes and velocity, caused by finite time steps. The velocity of a swimmer has
/// two parts, which have separate errors: the velocity that the mean Reynolds stress of the fluid causes, and
/// the drift by the displacements of the beads.
struct LagErrors {
  std::array<double, 2> arm_amplitudes{};  ///< positive if the amplitude of the run is too large
  double velocity = 0;                     ///< sum of the magnitudes of the errors of both parts
};

/// Evaluates the errors of one swimmer for any time step. The constructor computes all quantities that do not
/// depend on the step. In open space, the effect of sound is evaluated for each bead alone; sound from other
/// beads is neglected.
class LatticeLag {
 public:
  explicit LatticeLag(const Question& question);

  /// Returns the errors of a run with these time steps.
  LagErrors errors(const LatticeTiming& timing) const;

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
