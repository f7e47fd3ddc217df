#pragma once

#include <Eigen/Core>
#include <array>
#include <complex>
#include <optional>

#include "beadswim/theory/inertial_motion.hpp"
#include "beadswim/theory/question.hpp"

// What finite steps do to a swimmer in a lattice-Boltzmann fluid, however fine its cells: answers come late,
// and pressure goes by sound. To first order in the step, by the theory of motion with inertia
// (inertial_motion.hpp) with
//
//   eta(omega) = eta (1 - i omega t_s)      stress follows strain after t_s = nu/c^2 = (tau - 1/2) steps
//   M -> M(eta(omega)) + sound_flow         c = cell/(sqrt(3) step)
//   F = e^{-i omega step} (M^-1 - i omega m_f) U + i omega (m + zeta t_d) U
//
// m_f: fluid that a bead displaces; links answer a step late; t_d = 3/2 t_s + step: what delay correction
// adds to beads, zeta = 6 pi eta a. Page: docs/method/lattice-lag.md.

namespace beadswim {

/// The steps of a run.
struct LatticeTiming {
  double step = 0;         ///< [time]
  double sound_speed = 0;  ///< cell/(sqrt(3) step) [length/time]
  bool corrects_delay = true;
};

/// Errors by steps of finite length.
struct LagErrors {
  std::array<double, 2> arm_amplitudes{};  ///< relative, with their signs
  double velocity = 0;  ///< relative: those of drift and of Reynolds stress, not set off against each other
};

/// What does not depend on the steps, of one swimmer: in the question's box, or in open space, where beads
/// feel no sound of each other.
class LatticeLag {
 public:
  explicit LatticeLag(const Question& question);

  LagErrors errors(const LatticeTiming& timing) const;

 private:
  /// What a flow that is a function of omega rho/eta, over eta, is with frequencies a little lower and
  /// higher.
  struct Neighbours {
    Eigen::Matrix3cd at, below, above;

    /// With eta (1 - eps) in place of eta.
    Eigen::Matrix3cd with_late_stress(std::complex<double> eps) const;
  };
  struct Motion {
    Eigen::Vector2cd arm;
    double drift = 0, reynolds = 0;
  };

  template <class Flow>
  Neighbours neighbours(const Flow& flow) const;
  Motion motion(const Eigen::Matrix3cd& mobility, const Eigen::Matrix3cd& induced,
                const DriftForm& form) const;
  Eigen::Matrix3cd with_late_links(const Eigen::Matrix3cd& induced, const LatticeTiming& timing) const;

  InertialScene scene_;
  std::optional<BoxPlace> box_;
  Neighbours induced_, slopes_;
  DriftForm form_;
  Eigen::Matrix3cd reynolds_;
  Motion exact_;
};

}  // namespace beadswim
