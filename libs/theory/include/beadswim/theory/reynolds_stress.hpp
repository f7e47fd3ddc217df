#pragma once

#include <Eigen/Core>

#include "beadswim/theory/collinear_swimmer.hpp"

// Velocity V_R of a swimmer by the mean Reynolds stress of its own oscillating flow.
//
//   V_R = rho int <u u> : grad u^ dV = 1/2 Re sum_ij f_i f_j* Q_ij,    <u u> = 1/2 Re(u u*)
//
//   u    first-order flow: sum of the flows of isolated oscillating spheres with induced forces f_i
//   u^   steady flow of the three spheres, towed with equal velocity by the forces w, whose sum is 1. It is
//        approximated by the sum of the flows of isolated spheres.
//   Q    matrix of the quadratic form;  * denotes the complex conjugate
//
// The law follows from the Navier-Stokes equations to second order in amplitude by the reciprocal theorem.
//
// The integral extends over all space. Inside a sphere, the sphere's own flow is uniform, and the flows of
// the other spheres are evaluated by their formulas outside. With this choice, and at this level of
// approximation, the velocity of the swimmer does not depend on a common oscillation of beads and fluid.
//
// Page: docs/method/inertia.md.

namespace beadswim {

/// Matrix Q of the swimmer's velocity V_R = 1/2 Re sum_ij f_i f_j* Q_ij by the Reynolds stress of the induced
/// forces f, and the contribution of the volume of the beads to Q [time^3/(mass^2 length)]. Q is Hermitian.
struct ReynoldsForm {
  Eigen::Matrix3cd total;   ///< Q, the integral over all space
  Eigen::Matrix3cd inside;  ///< contribution of the volume of the beads, a measure of the error
};

/// Returns the matrix Q of the swimmer's velocity by the Reynolds stress in open space. `towing`: the forces
/// w on the three beads that tow the swimmer, sum 1. The error of an element is below 1e-5 of the largest
/// element, for penetration depths from 0.1 bead radii to 1000 arm lengths.
ReynoldsForm reynolds_stress_form(const CollinearSwimmer& swimmer, double fluid_density,
                                  const Eigen::Vector3d& towing);

/// Returns the swimmer's velocity V_R by the Reynolds stress [length/time] for the matrix Q = `form` and the
/// complex amplitudes of the induced forces of the three beads [mass length/time^2].
double reynolds_stress_velocity(const Eigen::Matrix3cd& form, const Eigen::Vector3cd& induced_force);

}  // namespace beadswim
