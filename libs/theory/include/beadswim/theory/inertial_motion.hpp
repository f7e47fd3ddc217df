#pragma once

#include <Eigen/Core>

#include "beadswim/mobility/line_flow.hpp"
#include "beadswim/theory/linear_response.hpp"
#include "beadswim/theory/question.hpp"
#include "beadswim/theory/reynolds_stress.hpp"

// Motion with inertia of fluid and beads, to second order in amplitude. Pairs of beads interact by the
// unsteady Faxen theorem, whose limit without inertia is the Rotne-Prager mobility.
//
// First order. The interior of the beads is treated as fluid. A bead then exerts the induced force f on the
// fluid:
//
//   f = F - i omega (m - m_f) U,    U = M f    =>    U = (1 + i omega M (m - m_f))^-1 M F
//
//   F, U    force on a bead [mass length/time^2] and its velocity [length/time], complex amplitudes
//   m, m_f  mass of the bead, mass of the fluid that it displaces [mass]
//   M       induced mobility: unsteady mobility of the pairs [time/mass]
//
// Second order, with the force distribution w of the rigid swimmer in steady flow:
//
//   V = sum_ji w_j 1/2 Re [ xi_j* (dR_ji/dx_j) f_i + xi_i* (dS_ji/dx_i) f_i ] + V_R
//
//   xi_i  displacement of bead i [length]
//   R_ji  mean of the unsteady flow of bead i over the surface of bead j: bead j moves in the flow of bead i
//   S_ji  steady flow at bead j due to the mean force dipole of the oscillating force f_i
//   V_R   velocity by the mean Reynolds stress (reynolds_stress.hpp)
//
// Without inertia R = S = mu and V_R = 0, and V is the velocity of second-order Rotne-Prager theory.
//
// Page: docs/method/inertia.md.

namespace beadswim {

/// A swimmer and its surroundings, for the theory with inertia.
struct InertialScene {
  CollinearSwimmer swimmer;
  double fluid_density = 0;   ///< rho [mass/length^3]
  LineFlow flow;              ///< flow of point forces in the surroundings
  LinePositions positions{};  ///< bead positions at rest, in the coordinate of `flow` [length]
};

/// Returns the scene in the question's box, or in open space if the question has no box.
InertialScene inertial_scene(const Question& question);

/// Returns the scene in open space, whether or not the question has a box.
InertialScene unbounded_scene(const Question& question);

/// Returns M of U = M f at the driving frequency, where f are the induced forces [time/mass].
Eigen::Matrix3cd induced_mobility(const InertialScene& scene);

/// Returns the mobility (1 + i omega M (m - m_f))^-1 M, which relates bead velocities to the forces F on the
/// beads at the driving frequency [time/mass].
Eigen::Matrix3cd unsteady_mobility(const InertialScene& scene);

/// Returns the induced forces f of beads that move as in `response` [mass length/time^2].
Eigen::Vector3cd induced_forces(const InertialScene& scene, const LinearResponse& response);

/// Coefficients of the first sum of V.
struct DriftForm {
  Eigen::Vector3d towing;        ///< w, sum 1
  Eigen::Matrix3cd by_receiver;  ///< dR_ji/dx_j in element (j, i) [time/(mass length)]
  Eigen::Matrix3cd by_source;    ///< dS_ji/dx_i in element (j, i) [time/(mass length)]
};

/// Evaluates the coefficients at the driving frequency.
DriftForm drift_form(const InertialScene& scene);

/// Returns the first sum of V, the drift due to the displacement of beads and forces [length/time]. `force`:
/// the induced forces f.
double lagrangian_drift(const DriftForm& form, const Eigen::Vector3cd& displacement,
                        const Eigen::Vector3cd& force);
double lagrangian_drift(const InertialScene& scene, const LinearResponse& response);

/// Returns Q of V_R (reynolds_stress.hpp) for the swimmer in open space.
ReynoldsForm reynolds_form(const InertialScene& scene);

}  // namespace beadswim
