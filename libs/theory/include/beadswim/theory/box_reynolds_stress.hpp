#pragma once

#include <Eigen/Core>
#include <optional>

#include "beadswim/theory/inertial_motion.hpp"
#include "beadswim/theory/question.hpp"

// Velocities of beads by the mean Reynolds stress of the oscillating flow in a box, by Fourier sums over a
// mesh.
//
//   u(k)   = P(k) x^ sum_i f_i phi_i(k) e^{-i k x_i} / (eta (k^2 + alpha^2) V)    first-order flow
//   s(k)   = -rho i k . <u u>(k),    <u u> = 1/2 Re(u u*)                         mean force by the Reynolds
//   stress V_j    = sum_k x^ . P(k) s(k) sin(k a_j)/(k a_j) e^{i k x_j} / (eta k^2)      mean velocity of
//   bead j
//
//   f_i, x_i, a_i   induced force (inertial_motion.hpp), position and radius of bead i; the sum over i
//   contains
//                   the mirror images at free-slip walls, in a box of twice the length
//   phi_i           Fourier transform of the induced force, on the surface and in the volume of the bead:
//                   [(1 + kappa) j_0(k a) + kappa^2 j_1(k a)/(k a)]/(1 + kappa + kappa^2/3), kappa = alpha a,
//                   with the spherical Bessel functions j_0 and j_1
//   P(k)            (1 - k k/k^2), x^: unit vector along the swimmer, V: volume of the box
//   alpha           sqrt(i omega rho/eta), rho and eta: density and dynamic viscosity of the fluid
//
// In open space the law is that of reynolds_stress.hpp. Page: docs/method/inertia.md.

namespace beadswim {

/// Returns the mean velocities V_j of the beads by the Reynolds stress [length/time]. `force`: complex
/// amplitudes of the induced forces [mass length/time^2]. The spacing of the mesh is the smallest radius; for
/// radii of 0.2 to 0.8 penetration depths the error is below 4 %. Returns nullopt for boxes so
/// large that the mesh would have more than 2^19 points.
std::optional<Eigen::Vector3d> reynolds_velocities_in_box(const CollinearSwimmer& swimmer,
                                                          double fluid_density, const BoxPlace& place,
                                                          const Eigen::Vector3cd& force);

}  // namespace beadswim
