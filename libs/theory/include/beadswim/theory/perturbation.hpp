#pragma once

#include <Eigen/Core>
#include <array>

#include "beadswim/mobility/collinear_mobility.hpp"
#include "beadswim/theory/collinear_swimmer.hpp"
#include "beadswim/theory/stroke.hpp"

// Mean velocity V and mean change m_i of the arms, to second order in the driving amplitude.
//
//   V = w^T <dmu f>,   w = mu^-1 1 / (1^T mu^-1 1),   dmu = sum_k (d mu / d x_k) xi_k
//   D mu D^T (k_i m_i) = D <dmu f>
//
//   xi, f  displacements and forces of the beads in the linear response (linear_response.hpp)
//   w      force distribution of a rigid swimmer, sum 1
//   m_i    mean change of arm i [length], for which the three beads have the same mean velocity
//   < >    mean over a period
//
// The mean tensions k_i m_i are internal forces, which the weights w eliminate from V. An unweighted mean of
// the bead velocities without m_i is not the velocity of the periodic motion.
//
// Page: docs/method/second-order-perturbation.md.

namespace beadswim {

/// Velocity, mean arms and stroke of the periodic motion at small amplitude.
struct SecondOrderMotion {
  double velocity = 0;                  ///< V, positive towards bead 3 [length/time]
  std::array<double, 2> arm_changes{};  ///< m_i = <L_i> - l_i [length]
  Stroke stroke;                        ///< stroke to first order
};

/// Returns w: the forces on the beads of a rigid swimmer that is towed along its axis, divided by their sum.
Eigen::Vector3d rigid_force_distribution(const Eigen::Matrix3d& mobility);

/// Returns the periodic motion to second order in A and B. `mobility`: mobility at rest and its derivatives.
SecondOrderMotion second_order_motion(const CollinearSwimmer& swimmer, const CollinearMobility& mobility);

/// Returns the second-order velocity for arms that change by Re(x_i exp(i omega t)), x = `arm`, independent
/// of the forces that drive them [length/time].
double velocity_of_stroke(const Eigen::Vector2cd& arm, const CollinearMobility& mobility,
                          double angular_frequency);

/// Returns the geometry factor C of V = C omega d_1 d_2 sin(delta_1 - delta_2) [1/length]. The law holds in
/// open space for any driving.
double geometry_factor(const CollinearMobility& mobility);

}  // namespace beadswim
