#pragma once

#include <Eigen/Core>
#include <array>

#include "beadswim/theory/question.hpp"

// Method inertia-corrected, the most accurate prediction of a resolved run. It combines exact Stokes flow of
// three spheres, finite amplitude, and corrections for inertia and box from Rotne-Prager theory.
//
// Stroke: the complex arm amplitudes x follow from the impedance Z of the arms.
//
//   (i omega Z + K) x = g,    Z = Z_exact + Z_unsteady - Z_RP,    each Z = (D mu D^T)^-1
//
//   Z_exact      exact steady mobility in open space
//   Z_unsteady   unsteady mobility of pairs in the box (inertial_motion.hpp)
//   Z_RP         steady Rotne-Prager mobility in open space
//   K, g, D      stiffness of the arms, tensions of the driving, arm rates (linear_response.hpp)
//
// Velocity to second order in amplitude, with V_drift and V_R of the theory with inertia for this stroke:
//
//   V = (C_exact / C_RP) (V_drift(x) + V_R(x)),
//
// where C is the geometry factor (perturbation.hpp). Without inertia
// V_drift + V_R = C_RP omega d_1 d_2 sin(delta_1 - delta_2).
//
// Finite amplitude: the difference between the periodic motion and second order, both in exact Stokes flow,
// is scaled with |x_1 x_2| and added to the velocity. The ratio of the two strokes multiplies x.
//
// Page: docs/method/inertia.md.

namespace beadswim {

/// Contributions to the velocity, which sum() adds, and the uncertainty of the sum [length/time].
struct InertialVelocity {
  double quasi_static = 0;        ///< exact Stokes flow in open space, to second order
  double by_stroke = 0;           ///< change because inertia changes the stroke
  double by_drift = 0;            ///< change because the flow around moving beads is unsteady
  double by_reynolds_stress = 0;  ///< mean Reynolds stress, in open space
  double by_box = 0;              ///< change by the box
  double by_amplitude = 0;        ///< change from second order to finite amplitude
  double uncertainty = 0;         ///< absolute uncertainty of the sum

  double sum() const {
    return quasi_static + by_stroke + by_drift + by_reynolds_stress + by_box + by_amplitude;
  }
};

/// Velocity and stroke by the method inertia-corrected.
struct InertiaCorrected {
  InertialVelocity velocity;
  Eigen::Vector2cd arm;                           ///< complex arm amplitudes x_i at finite amplitude [length]
  std::array<double, 2> arm_means{};              ///< mean arm lengths [length]
  std::array<double, 2> amplitude_uncertainty{};  ///< relative uncertainty of |x_i|
  double sin_uncertainty = 0;                     ///< absolute uncertainty of sin(delta_1 - delta_2)
};

/// Evaluates the method. Requires `question.exact`. Throws InputError if no periodic motion without contact
/// is found.
InertiaCorrected inertia_corrected(const Question& question);

}  // namespace beadswim
