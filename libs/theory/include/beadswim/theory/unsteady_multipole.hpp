#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>
#include <vector>

#include "beadswim/collinear/oscillating_spheres.hpp"
#include "beadswim/theory/collinear_swimmer.hpp"
#include "beadswim/theory/linear_response.hpp"

// Exact motion of a swimmer with inertia of fluid and beads in unbounded fluid, to second order in the
// amplitude, by multipole expansion (oscillating_spheres.hpp).
//
//   first order    U = M F,   M = (Z + i omega m)^-1
//   second order   V = sum_k f_k / sum_jk R_jk,   because the mean forces f_k - sum_j R_kj V sum to zero
//   arms           k_1 m_1 = R_1 V - f_1,   k_2 m_2 = f_3 - R_3 V,   R_k = sum_j R_kj
//
//   U, F  velocities of the beads; forces of driving, springs and dashpots  [length/time, mass length/time^2]
//   Z, R  resistance of oscillating flow, of steady flow [mass/time];  m  masses of the beads [mass]
//   V     mean velocity of the swimmer [length/time]
//   f_k   mean force of the fluid on bead k at V = 0 [mass length/time^2]
//   k_i   stiffness of arm i [mass/time^2];  m_i  mean change of the length of arm i [length]
//
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

/// Numbers of multipoles and of quadrature nodes (per panel and direction), which determine the numerical
/// error.
struct MultipoleResolution {
  int order, nodes;
};

/// Flow of a swimmer at rest length to second order in the velocities of its beads.
struct UnsteadyMultipoles {
  Eigen::Matrix3cd mobility;          ///< M [time/mass]
  Eigen::Matrix3cd induced_mobility;  ///< bead velocities per induced force (inertial_motion.hpp) [time/mass]
  MeanForces mean_forces;
};

/// Mean velocity and mean changes of the arm lengths, to second order in the amplitude.
struct MeanMotion {
  double by_drift = 0;                  ///< contribution of the Lagrangian drift to V [length/time]
  double by_reynolds_stress = 0;        ///< contribution of the Reynolds stress to V [length/time]
  std::array<double, 2> arm_changes{};  ///< m_i: mean length of arm i minus rest length [length]
  /// R^-1 f: mean velocities that the beads would have without mean forces [length/time].
  Eigen::Vector3d bead_velocities = Eigen::Vector3d::Zero();

  double velocity() const { return by_drift + by_reynolds_stress; }
};

/// Motion of the driven swimmer in unbounded fluid, exact to second order in the amplitude.
struct ExactMotion {
  LinearResponse response;
  MeanMotion mean;
};

/// Returns the resolution at which the relative error of V is about 1e-8 or less for l >= 2.5 lambda; nullopt
/// if the beads are so close that more than 100 multipoles per sphere are necessary.
std::optional<MultipoleResolution> sufficient_resolution(const CollinearSwimmer& swimmer);

/// Returns a coarser resolution. The change of a result from the coarser to the finer resolution is an upper
/// bound of its numerical error.
MultipoleResolution coarser(const MultipoleResolution& resolution);

/// Solves for the flow. `fluid_density` [mass/length^3] must be positive.
UnsteadyMultipoles unsteady_multipoles(const CollinearSwimmer& swimmer, double fluid_density,
                                       const MultipoleResolution& resolution);

/// Returns the mean motion of beads that oscillate with the complex velocities i omega `displacement` in the
/// flow that beads with the complex velocities `flow_velocity` cause. The two velocities are equal in
/// unbounded fluid.
MeanMotion mean_motion(const UnsteadyMultipoles& flow, const CollinearSwimmer& swimmer,
                       const Eigen::Vector3cd& displacement, const Eigen::Vector3cd& flow_velocity);

/// Returns the mean motion for the linear response `response` in unbounded fluid to any driving with the
/// frequency of `swimmer`.
MeanMotion mean_motion(const UnsteadyMultipoles& flow, const CollinearSwimmer& swimmer,
                       const LinearResponse& response);

/// Returns the motion under the driving of `swimmer`.
ExactMotion exact_motion(const UnsteadyMultipoles& flow, const CollinearSwimmer& swimmer);

}  // namespace beadswim
