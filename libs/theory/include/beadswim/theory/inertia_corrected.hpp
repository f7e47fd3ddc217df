#pragma once

#include <Eigen/Core>
#include <array>

#include "beadswim/theory/question.hpp"

// Method inertia-corrected, the most accurate prediction of a resolved run. It combines exact Stokes flow of
// three spheres at finite amplitude with corrections for inertia and for the box. The corrections are
// evaluated with unsteady Rotne-Prager pairs (inertial_motion.hpp).
//
// Stroke: the complex arm amplitudes x follow from the impedance Z of the arms.
//
//   (i omega Z + K) x = g,    Z = Z_exact + Z_unsteady - Z_RP,    each Z = (D mu D^T)^-1
//
//   Z_exact      mu is the exact steady mobility in open space
//   Z_unsteady   mu is the unsteady mobility of pairs in the box (inertial_motion.hpp)
//   Z_RP         mu is the steady Rotne-Prager mobility in open space
//   K, g         stiffness of the arms, tensions of the arms by the driving (linear_response.hpp)
//   D            matrix that maps bead velocities to rates of the arm lengths (linear_response.hpp)
//
// Velocity to second order in amplitude. V_drift and V_R are the sum and the last term of V in
// inertial_motion.hpp, evaluated for this stroke:
//
//   V = (C_exact / C_RP) (V_drift(x) + V_R(x)),
//
// where C is the geometry factor (perturbation.hpp). Without inertia
//   V_drift + V_R = C_RP omega d_1 d_2 sin(delta_1 - delta_2),   d, delta: arm amplitudes and phases.
//
// Finite amplitude: two motions in exact Stokes flow are compared, the periodic motion at finite amplitude
// and the motion to second order. The difference of their velocities, scaled with |x_1 x_2|, is added to V.
// The ratio of their complex arm amplitudes multiplies x.
//
// Page: docs/method/inertia.md.

namespace beadswim {

/// Contributions to the velocity, which sum() adds, and the uncertainty of the sum [length/time].
struct InertialVelocity {
  double quasi_static = 0;        ///< exact Stokes flow in open space, to second order
  double by_stroke = 0;           ///< change because inertia changes the stroke
  double by_drift = 0;            ///< change because the flow around moving beads is unsteady
  double by_reynolds_stress = 0;  ///< mean Reynolds stress, in open space
  double by_box = 0;              ///< change because of the images in the box
  double by_amplitude = 0;        ///< change because the amplitude is finite
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
