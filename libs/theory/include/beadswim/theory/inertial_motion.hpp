#pragma once

#include <Eigen/Core>

#include "beadswim/collinear/line_flow.hpp"
#include "beadswim/theory/linear_response.hpp"
#include "beadswim/theory/question.hpp"
#include "beadswim/theory/reynolds_stress.hpp"

// Motion with inertia of fluid and beads, to second order in amplitude. The interaction of two beads follows
// from the unsteady Faxen theorem. Without inertia it is the Rotne-Prager mobility.
//
// First order. The interior of the beads is treated as fluid. A bead then exerts the induced force f on the
// fluid:
//
//   f = F - i omega (m - m_f) U,    U = M f    =>    U = (1 + i omega M (m - m_f))^-1 M F
//
//   F, U    force of driving, springs and dashpots on a bead [mass length/time^2], and its velocity
//           [length/time]: complex amplitudes
//   m, m_f  mass of the bead, mass of the fluid that it displaces [mass]
//   M       induced mobility: velocities of the beads per induced force [time/mass]
//
// Second order (* denotes the complex conjugate):
//
//   V = sum_ji w_j 1/2 Re [ xi_j* (dR_ji/dx_j) f_i + xi_i* (dS_ji/dx_i) f_i ] + V_R
//
//   w_j   share of bead j in the force that tows the rigid swimmer in steady flow, sum 1
//   xi_i  displacement of bead i [length]
//   R_ji  unsteady flow of bead i per force f_i, averaged over the surface of bead j [time/mass]. The term
//         with dR_ji/dx_j exists because bead j moves in this flow.
//   S_ji  steady flow at bead j per force at bead i [time/mass]. The term with dS_ji/dx_i exists because the
//         oscillating force f_i moves with bead i, which makes a mean force dipole.
//   V_R   velocity by the mean Reynolds stress (reynolds_stress.hpp) [length/time]
//
// Without inertia R and S are the Rotne-Prager mobility, V_R is zero, and V is the velocity of second-order
// Rotne-Prager theory (linear_response.hpp).
//
// Page: docs/method/inertia.md.

namespace beadswim {

/// A swimmer in its fluid, which fills a box or open space, for the theory with inertia.
struct InertialScene {
  CollinearSwimmer swimmer;
  double fluid_density = 0;   ///< rho [mass/length^3]
  LineFlow flow;              ///< flow of point forces in the box or in open space
  LinePositions positions{};  ///< bead positions at rest on the line of `flow` [length]
};

/// Returns the swimmer in the question's box, or in open space if the question has no box.
InertialScene inertial_scene(const Question& question);

/// Returns the swimmer in open space, whether or not the question has a box.
InertialScene unbounded_scene(const Question& question);

/// Returns the matrix M of U = M f at the driving frequency: bead velocities U per induced force f of the
/// beads on the fluid [time/mass].
Eigen::Matrix3cd induced_mobility(const InertialScene& scene);

/// Returns the mobility (1 + i omega M (m - m_f))^-1 M at the driving frequency, which relates bead
/// velocities to the forces F of driving, springs and dashpots [time/mass]. M: induced_mobility(); m, m_f:
/// masses of a bead and of the fluid that it displaces.
Eigen::Matrix3cd unsteady_mobility(const InertialScene& scene);

/// Returns the induced forces f, which the beads exert on the fluid if they move as in `response`
/// [mass length/time^2].
Eigen::Vector3cd induced_forces(const InertialScene& scene, const LinearResponse& response);

/// Coefficients of the Lagrangian drift, the sum over i and j in the velocity V. R_ji and S_ji are the
/// unsteady and the steady flow at bead j per force of bead i.
struct DriftForm {
  Eigen::Vector3d towing;        ///< w_j, share of bead j in the force that tows the rigid swimmer, sum 1
  Eigen::Matrix3cd by_receiver;  ///< dR_ji/dx_j in element (j, i) [time/(mass length)]
  Eigen::Matrix3cd by_source;    ///< dS_ji/dx_i in element (j, i) [time/(mass length)]
};

/// Returns the coefficients of the Lagrangian drift at the driving frequency.
DriftForm drift_form(const InertialScene& scene);

/// Returns the mean velocities of the beads due to the displacement of beads and induced forces: the sums
/// over i in V, without w_j [length/time]. `displacement`: complex amplitudes of the bead displacements
/// [length], `force`: induced forces f [mass length/time^2].
Eigen::Vector3d drift_velocities(const DriftForm& form, const Eigen::Vector3cd& displacement,
                                 const Eigen::Vector3cd& force);

/// Returns the Lagrangian drift, the part of the swimmer's velocity due to the displacement of beads and
/// induced forces (sum over i and j in V) [length/time].
double lagrangian_drift(const InertialScene& scene, const LinearResponse& response);

/// Returns Q, the coefficients of the swimmer's velocity V_R by the Reynolds stress (reynolds_stress.hpp),
/// for the swimmer in open space.
ReynoldsForm reynolds_form(const InertialScene& scene);

}  // namespace beadswim
