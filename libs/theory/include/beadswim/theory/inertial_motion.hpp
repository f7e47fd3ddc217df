#pragma once

#include <Eigen/Core>

#include "beadswim/mobility/line_flow.hpp"
#include "beadswim/theory/linear_response.hpp"
#include "beadswim/theory/question.hpp"
#include "beadswim/theory/reynolds_stress.hpp"

// Motion with inertia of fluid and beads, to second order in amplitude; pairs interact by the unsteady Faxen
// theorem, which is Rotne-Prager without inertia.
//
// First order: with fluid thought to fill the beads, each pushes it with f = F - i omega (m - m_f) U, m_f its
// displaced mass, and U = M f, M the pairs' unsteady mobility. So U = (1 + i omega M (m - m_f))^-1 M F.
//
// Second order, with w the force distribution of the rigid swimmer in steady flow:
//
//   V = sum_ji w_j 1/2 Re [ xi_j* (dR_ji/dx_j) f_i + xi_i* (dS_ji/dx_i) f_i ] + V_R
//
//   R_ji  unsteady flow of bead i, its mean over the surface of bead j: the beads move in each other's flow
//   S_ji  steady flow at bead j of the mean force dipole that a moving force leaves
//   V_R   by the mean Reynolds stress (reynolds_stress.hpp)
//
// Without inertia R = S = mu, V_R = 0 and V is second-order Rotne-Prager theory.
//
// Page: docs/method/inertia.md.

namespace beadswim {

/// Where a swimmer moves in inertial theory.
struct InertialScene {
  CollinearSwimmer swimmer;
  double fluid_density = 0;   ///< rho [mass/length^3]
  LineFlow flow;              ///< of the surroundings
  LinePositions positions{};  ///< of the beads at rest in it [length]
};

/// The question's scene: in its box, or unbounded.
InertialScene inertial_scene(const Question& question);
InertialScene unbounded_scene(const Question& question);

/// M of U = M f at the driving's frequency, f what the beads push the fluid with [time/mass].
Eigen::Matrix3cd induced_mobility(const InertialScene& scene);

/// U = M F of the beads at the driving's frequency, F the forces on them [time/mass].
Eigen::Matrix3cd unsteady_mobility(const InertialScene& scene);

/// What the beads push the fluid with, where they move as in `response`.
Eigen::Vector3cd induced_forces(const InertialScene& scene, const LinearResponse& response);

/// w, dR_ji/dx_j and dS_ji/dx_i of the first sum of V.
struct DriftForm {
  Eigen::Vector3d towing;
  Eigen::Matrix3cd by_receiver;  ///< [1/(mass/time length)]
  Eigen::Matrix3cd by_source;    ///< [1/(mass/time length)]
};
DriftForm drift_form(const InertialScene& scene);

/// The first sum of V: by the beads' and forces' own displacement [length/time].
double lagrangian_drift(const DriftForm& form, const Eigen::Vector3cd& displacement,
                        const Eigen::Vector3cd& force);
double lagrangian_drift(const InertialScene& scene, const LinearResponse& response);

/// Q of V_R (reynolds_stress.hpp) for the swimmer in open space.
ReynoldsForm reynolds_form(const InertialScene& scene);

}  // namespace beadswim
