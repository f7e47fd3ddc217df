#pragma once

#include <Eigen/Core>
#include <vector>

#include "beadswim/collinear/oscillating_spheres.hpp"

// clang-format off
// Mean forces of the fluid on spheres that oscillate on a line, to second order in the amplitude, in unbounded fluid.
//
// The mean flow <u2> is steady Stokes flow with the body force -rho <u1 . grad u1>. On the mean surface of sphere j it
// equals V_j - <xi_j du1/dx>, because the sphere moves in the gradient of the first-order flow u1. The reciprocal theorem
// gives the mean force on sphere k from the steady flow u^k, in which sphere k moves at unit velocity along x and the
// others are at rest:
//
//   <F_k> = - sum_j R_kj V_j - sum_j int_j <xi_j du1/dx> . t^k dS + rho int_outside <u1 u1> : grad u^k dV
//
//   U_j, xi_j   velocity of sphere j, displacement U_j/(i omega)     [length/time, length]
//   V_j         mean velocity of sphere j                            [length/time]
//   R           resistance of steady flow                            [mass/time]
//   t^k         traction of the fluid on the surfaces in the flow u^k [mass/(length^2 time)]
//   rho         fluid density                                        [mass/length^3]
//   < >         mean over a period, <p q> = 1/2 Re(p q*)
//
// On a surface, u1 is constant and div u1 = 0. Therefore du1/dx = cos(theta) (du_theta/dr) e_theta there, and only the
// tangential part eta du^k_theta/dr of the traction contributes.
// clang-format on
//
// Page: docs/method/unsteady-multipole.md.

namespace beadswim {

/// Forms of the mean forces on N spheres:
///   <F_k> = -(R V)_k + 1/2 Re sum_ij U_i [ (i omega xi_j)* drift_k,ij + U_j* reynolds_k,ij ].
struct MeanForces {
  Eigen::MatrixXd resistance;              ///< R of steady flow, N x N [mass/time]
  std::vector<Eigen::MatrixXcd> drift;     ///< by the displacements, for the force on sphere k [mass/length]
  std::vector<Eigen::MatrixXcd> reynolds;  ///< by the Reynolds stress [mass/length]
};

/// Evaluates the mean forces. `unsteady` and `steady` are flows around the same spheres, the second with
/// alpha = 0. `viscosity` is dynamic [mass/(length time)], `angular_frequency` in [radian/time]. `nodes`:
/// number of nodes per panel and direction of the quadrature over the fluid.
MeanForces mean_forces(const OscillatingSpheres& unsteady, const OscillatingSpheres& steady, double viscosity,
                       double angular_frequency, int nodes);

/// Returns 1/2 Re sum_ij U_i W_j* form_ij for complex velocities U and W.
double mean_of(const Eigen::MatrixXcd& form, const Eigen::VectorXcd& u, const Eigen::VectorXcd& w);

}  // namespace beadswim
