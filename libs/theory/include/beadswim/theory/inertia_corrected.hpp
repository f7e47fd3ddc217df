#pragma once

#include <Eigen/Core>
#include <array>

#include "beadswim/theory/question.hpp"

// Method inertia-corrected, the most accurate prediction of a resolved run. It adds the box and finite
// amplitude to the exact motion with inertia in unbounded fluid (unsteady_multipole.hpp).
//
// First order: the bead velocities per force on the beads are the mobility
//
//   M = M_exact + M_box - M_open
//
//   M_exact  exact unsteady mobility in open space
//   M_box    unsteady mobility of pairs of beads with their images in the box (inertial_motion.hpp)
//   M_open   the same in open space
//
// The linear response (linear_response.hpp) with M gives the complex arm amplitudes x, the bead displacements
// xi and the induced forces f.
//
// Second order: V = sum_j w_j [u_j + q (u_j,box - u_j,open)] + V_R,box - V_R,open
//
//   u_j      exact mean velocities of the beads without mean forces (unsteady_multipole.hpp): the beads have
//            the displacements xi in the flow that the forces f cause in open space
//   u_j,box  mean velocities by pairs in the box (drift_velocities);  u_j,open: by pairs in open space
//   q        C_exact/C_RP, geometry factors in open space by exact and by Rotne-Prager mobilities: beads of
//            finite size weaken the flow between them, compared with pairs
//   V_R      velocity by the Reynolds stress of pairs, in the box and in open space (reynolds_stress.hpp)
//   w_j      share of bead j in the force that tows the rigid swimmer in the box, sum 1. The steady mobility
//            is the exact one, plus that of pairs in the box, minus that of pairs in open space
//
// Finite amplitude: two quasi-static motions in exact Stokes flow are compared, the periodic motion at finite
// amplitude (velocity V_f, complex arm amplitudes y) and the motion to second order (velocity V_2, arm
// amplitudes z). With s = |x_1 x_2|/|z_1 z_2|, the term s^2 (V_f - V_2) is added to V, and x_i is multiplied
// by 1 + s (y_i/z_i - 1). The effect of images on the mean arm
// lengths is left out.
//
// Page: docs/method/inertia.md.

namespace beadswim {

/// Contributions to the swimmer's velocity by the method inertia-corrected, which sum() adds, and the
/// uncertainty of the sum [length/time].
struct InertialVelocity {
  double quasi_static = 0;        ///< exact Stokes flow in open space, to second order
  double by_stroke = 0;           ///< change because inertia changes the stroke
  double by_drift = 0;            ///< change because the flow around moving beads is unsteady
  double by_reynolds_stress = 0;  ///< mean Reynolds stress, in open space
  double by_box = 0;              ///< change because of the images in the box
  double by_amplitude = 0;        ///< change because the driving amplitude is finite
  double uncertainty = 0;         ///< absolute uncertainty of the sum

  double sum() const {
    return quasi_static + by_stroke + by_drift + by_reynolds_stress + by_box + by_amplitude;
  }
};

/// Velocity and stroke of a swimmer by the method inertia-corrected.
struct InertiaCorrected {
  InertialVelocity velocity;
  Eigen::Vector2cd arm;                           ///< complex arm amplitudes x_i at finite amplitude [length]
  std::array<double, 2> arm_means{};              ///< mean arm lengths [length]
  std::array<double, 2> amplitude_uncertainty{};  ///< relative uncertainty of |x_i|
  double sin_uncertainty = 0;                     ///< absolute uncertainty of sin(delta_1 - delta_2)
};

/// Returns velocity and stroke by the method inertia-corrected. Throws InputError if beads nearly touch, or
/// if no periodic motion without contact is found.
InertiaCorrected inertia_corrected(const Question& question);

}  // namespace beadswim
