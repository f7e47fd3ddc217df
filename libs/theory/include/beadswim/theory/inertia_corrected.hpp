#pragma once

#include <Eigen/Core>
#include <array>

#include "beadswim/theory/question.hpp"

// The best prediction of a resolved run: exact Stokes flow of three spheres, at finite amplitude, with
// inertia and the box from Rotne-Prager theory.
//
// Stroke: the arms' impedances add, Z = (D mu D^T)^-1 exact, plus the same of the unsteady pairs in the box
// less that of the steady unbounded pairs; (i omega Z + K) x = g, g the driving's tensions. Velocity to
// second order:
//
//   V = C_exact / C_RP  (V_drift(x) + V_R(x)),
//
// V_drift + V_R of inertial theory for this stroke, which is C_RP omega d_1 d_2 sin(delta_1 - delta_2)
// without inertia. Amplitude: the change of velocity and stroke that exact Stokes flow shows between second
// order and the periodic motion. Page: docs/method/inertia.md.

namespace beadswim {

/// The velocity as a sum of parts, and what is not known of them [length/time].
struct InertialVelocity {
  double quasi_static = 0;  ///< exact Stokes flow, second order, unbounded
  double by_stroke = 0;     ///< the stroke that inertia changes
  double by_drift = 0;      ///< beads and forces moving in unsteady flow
  double by_reynolds_stress = 0;
  double by_box = 0;
  double by_amplitude = 0;
  double uncertainty = 0;  ///< of the whole, from those of the parts

  double sum() const {
    return quasi_static + by_stroke + by_drift + by_reynolds_stress + by_box + by_amplitude;
  }
};

struct InertiaCorrected {
  InertialVelocity velocity;
  Eigen::Vector2cd arm;                           ///< x_i at finite amplitude [length]
  std::array<double, 2> arm_means{};              ///< [length]
  std::array<double, 2> amplitude_uncertainty{};  ///< relative, of |x_i|
  double sin_uncertainty = 0;                     ///< absolute, of sin(delta_1 - delta_2)
};

/// Needs the question's exact reference. Throws InputError where no periodic motion without contact exists.
InertiaCorrected inertia_corrected(const Question& question);

}  // namespace beadswim
