#pragma once

#include <Eigen/Core>

#include "beadswim/theory/collinear_swimmer.hpp"

// Velocity V_R of a swimmer by the mean Reynolds stress of its own oscillating flow.
//
//   V_R = rho int <u u> : grad u^ dV = 1/2 Re sum_ij f_i f_j* Q_ij,    <u u> = 1/2 Re(u u*)
//
//   u    first-order flow: sum of the flows of isolated oscillating spheres with induced forces f_i
//   u^   steady flow of the three spheres, towed with equal velocity by forces w with the sum 1: sum of the
//        flows of isolated spheres
//
// The law follows from the Navier-Stokes equations to second order in amplitude by the reciprocal theorem.
//
// The integral extends over all space. Inside a sphere, the sphere's own flow is uniform, and the flows of
// the other spheres are continued. At this level of approximation, this choice makes V independent of a
// common oscillation of beads and fluid.
//
// Page: docs/method/inertia.md.

namespace beadswim {

/// Q, a Hermitian matrix, and its contribution from the beads [time^3/(mass^2 length)].
struct ReynoldsForm {
  Eigen::Matrix3cd total;   ///< integral over all space
  Eigen::Matrix3cd inside;  ///< contribution of the volume of the beads, a measure of the approximation
};

/// Returns Q in open space. `towing`: share w of each bead in the towing force, sum 1. The error is below
/// 1e-5 of the largest element, for penetration depths from a tenth of a radius to a thousand arms.
ReynoldsForm reynolds_stress_form(const CollinearSwimmer& swimmer, double fluid_density,
                                  const Eigen::Vector3d& towing);

/// Returns V_R [length/time] for the complex amplitudes of the induced forces [mass length/time^2].
double reynolds_stress_velocity(const Eigen::Matrix3cd& form, const Eigen::Vector3cd& induced_force);

}  // namespace beadswim
