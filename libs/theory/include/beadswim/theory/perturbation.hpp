#pragma once

#include <Eigen/Core>
#include <array>

#include "beadswim/collinear/collinear_mobility.hpp"
#include "beadswim/theory/collinear_swimmer.hpp"
#include "beadswim/theory/stroke.hpp"

// Mean velocity V and mean changes m_i of the arm lengths, to second order in the driving amplitude.
//
//   V = w^T <dmu f>,   w = mu^-1 1 / (1^T mu^-1 1),   dmu = sum_k (d mu / d x_k) xi_k
//   D mu D^T (k_i m_i) = D <dmu f>
//
//   mu     mobility at rest [time/mass];  dmu  its change by the bead displacements
//   xi, f  displacements and forces of the beads in the linear response (linear_response.hpp)
//   w      force distribution of a rigid swimmer, sum 1;  1 in its formula is the vector (1, 1, 1)
//   m_i    mean change of arm i [length], which gives the three beads the same mean velocity
//   k_i    stiffness of arm i;  D  matrix that maps bead velocities to rates of the arm lengths
//   < >    mean over a period
//
// The mean tensions k_i m_i are internal forces, which the weights w eliminate from V. The unweighted mean of
// the bead velocities, evaluated without m_i, is not the velocity of the periodic motion.
//
// Page: docs/method/second-order-perturbation.md.

namespace beadswim {

/// Velocity, mean arms and stroke of the periodic motion at small amplitude.
struct SecondOrderMotion {
  double velocity = 0;                  ///< V, positive towards bead 3 [length/time]
  std::array<double, 2> arm_changes{};  ///< m_i: mean length of arm i minus rest length [length]
  Stroke stroke;                        ///< stroke to first order in the driving amplitude
};

/// Returns w: the forces on the beads of a rigid swimmer that is towed along its axis, divided by their sum.
/// `mobility`: of the three beads [time/mass].
Eigen::Vector3d rigid_force_distribution(const Eigen::Matrix3d& mobility);

/// Returns the periodic motion to second order in the driving amplitudes A and B. `mobility`: mobility of the
/// beads at rest, with its derivatives.
SecondOrderMotion second_order_motion(const CollinearSwimmer& swimmer, const CollinearMobility& mobility);

/// Returns the swimmer's velocity to second order in the arm amplitudes if the arm lengths change by
/// Re(x_i exp(i omega t)) [length/time]. x = `arm` [length], omega = `angular_frequency`; `mobility`:
/// mobility of the beads at rest. The velocity does not depend on the forces that cause this stroke.
double velocity_of_stroke(const Eigen::Vector2cd& arm, const CollinearMobility& mobility,
                          double angular_frequency);

/// Returns the geometry factor C of the swimmer's velocity V = C omega d_1 d_2 sin(delta_1 - delta_2) to
/// second order in the arm amplitudes d [1/length], delta: arm phases. This law is valid in open space for
/// any driving.
double geometry_factor(const CollinearMobility& mobility);

}  // namespace beadswim
