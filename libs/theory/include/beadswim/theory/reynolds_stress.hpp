#pragma once

#include <Eigen/Core>
#include <optional>

#include "beadswim/theory/collinear_swimmer.hpp"
#include "beadswim/theory/question.hpp"

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
// In a box, the mean velocities V_j of the beads follow from Fourier sums over a mesh:
//
// clang-format off
//   u(k)   =  P(k) x^ sum_i f_i phi_i(k) e^{-i k x_i} / (eta (k^2 + alpha^2) V)       first-order flow
//   s(k)   =  -rho i k . <u u>(k)                                                     mean force by the Reynolds stress
//   V_j    =  sum_k x^ . P(k) s(k) sin(k a_j)/(k a_j) e^{i k x_j} / (eta k^2)         mean velocity of bead j
//   phi_i  =  [(1 + kappa) j_0(k a_i) + kappa^2 j_1(k a_i)/(k a_i)] / (1 + kappa + kappa^2/3),   kappa = alpha a_i
//
//   x_i, a_i   position and radius of bead i; the sum over i contains the mirror images at free-slip walls, in a box of
//              twice the length
//   phi_i      Fourier transform of the induced force on the surface and in the volume of the bead, with the spherical
//              Bessel functions j_0 and j_1
//   P(k)       (1 - k k/k^2);  x^ unit vector along the swimmer;  V volume of the box
//   alpha      sqrt(i omega rho/eta);  rho, eta density and dynamic viscosity of the fluid
// clang-format on
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

/// Returns the mean velocities V_j of the beads in a box by the Reynolds stress [length/time]. `force`:
/// complex amplitudes of the induced forces [mass length/time^2]. The spacing of the mesh is the smallest
/// radius; for radii of 0.2 to 0.8 penetration depths the error is below 4 %. Returns nullopt for boxes so
/// large that the mesh would have more than 2^19 points.
std::optional<Eigen::Vector3d> reynolds_velocities_in_box(const CollinearSwimmer& swimmer,
                                                          double fluid_density, const BoxPlace& place,
                                                          const Eigen::Vector3cd& force);

}  // namespace beadswim
