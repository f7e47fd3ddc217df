#pragma once

#include <Eigen/Core>

#include "beadswim/theory/collinear_swimmer.hpp"

// Velocity of a swimmer by the mean Reynolds stress of its own oscillating flow.
//
//   V_R = rho int <u u> : grad u^ dV = 1/2 Re sum_ij f_i f_j* Q_ij,    <u u> = 1/2 Re(u u*)
//
// u   first-order flow: sum of the flows of lone oscillating spheres with induced forces f_i
// u^  steady flow of the three spheres towed alike by a unit force, shared as w: sum of the flows of lone
//     spheres
//
// Each sphere's own flow is uniform inside it. The integral is over all space, with the others' flows
// going on inside a sphere: at this level of approximation that keeps V independent of a common oscillation
// of beads and fluid. By the reciprocal theorem from the Navier-Stokes equations to second order in
// amplitude.
//
// Page: docs/method/inertia.md.

namespace beadswim {

/// Q, a Hermitian matrix [time^3/(mass^2 length)].
struct ReynoldsForm {
  Eigen::Matrix3cd whole;   ///< by all space
  Eigen::Matrix3cd inside;  ///< of it by the volume of the beads: what this level of approximation adds
};

/// Q in open space, for the share of each bead in the towing force, summing to 1. Its error is below 1e-5 of
/// its largest entry, for penetration depths from a tenth of a radius to a thousand arms.
ReynoldsForm reynolds_stress_form(const CollinearSwimmer& swimmer, double fluid_density,
                                  const Eigen::Vector3d& towing);

/// V_R for complex amplitudes of the induced forces [mass length/time^2] -> [length/time].
double reynolds_stress_velocity(const Eigen::Matrix3cd& form, const Eigen::Vector3cd& induced_force);

}  // namespace beadswim
