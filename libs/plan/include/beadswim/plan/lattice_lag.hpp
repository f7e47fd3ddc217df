#pragma once

#include <Eigen/Core>
#include <array>
#include <complex>
#include <optional>

#include "beadswim/theory/inertial_motion.hpp"
#include "beadswim/theory/question.hpp"

// Errors that finite time steps cause in a lattice-Boltzmann run, even on arbitrarily fine cells. Stress and
// bead forces are delayed, and pressure propagates with the speed of sound. The errors are evaluated to first
// order in the time step by the theory of motion with inertia (inertial_motion.hpp), with these replacements:
//
//   eta(omega) = eta (1 - i omega t_s)      stress lags strain by t_s = nu/c^2 = (tau - 1/2) steps
//   M -> M(eta(omega)) + sound_flow         c = cell/(sqrt(3) step)
//   F = e^{-i omega step} (M^-1 - i omega m_f) U + i omega (m + zeta t_d) U
//
//   c     speed of sound of the lattice [length/time]
//   step  time step [time]: forces by links act one step late, hence e^{-i omega step}
//   M     induced mobility;  F, U force on a bead and its velocity;  m, m_f mass of bead and displaced fluid
//   t_d   = 3/2 t_s + step, delay that the delay correction compensates by the added mass zeta t_d [time]
//   zeta  = 6 pi eta a [mass/time]
//
// Page: docs/method/lattice-lag.md.

namespace beadswim {

/// Time step and speed of sound of a lattice run.
struct LatticeTiming {
  double step = 0;             ///< time step [time]
  double sound_speed = 0;      ///< cell/(sqrt(3) step) [length/time]
  bool corrects_delay = true;  ///< whether the delay correction adds mass to beads
};

/// Relative errors by finite time steps.
struct LagErrors {
  std::array<double, 2> arm_amplitudes{};  ///< with their signs
  double velocity = 0;                     ///< sum of the absolute errors of drift and Reynolds stress
};

/// Evaluates the errors of one swimmer for any time step. The constructor computes all quantities that do not
/// depend on the step. In open space, sound is taken into account for each bead alone, not between beads.
class LatticeLag {
 public:
  explicit LatticeLag(const Question& question);

  /// Returns the errors of a run with these time steps.
  LagErrors errors(const LatticeTiming& timing) const;

 private:
  /// Matrix that depends on omega rho/eta and is proportional to 1/eta, at the driving frequency and at a
  /// slightly lower and a slightly higher frequency.
  struct FrequencySamples {
    Eigen::Matrix3cd at, below, above;

    /// Returns the matrix with eta (1 - eps) in place of eta, to first order in eps.
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
