#pragma once

#include <Eigen/Core>
#include <array>

#include "beadswim/mobility/collinear_mobility.hpp"
#include "beadswim/theory/collinear_swimmer.hpp"
#include "beadswim/theory/stroke.hpp"

// Second order in the driving amplitude: mean velocity and mean change of the arms.
//
//   V = w^T <dmu f>,   w = mu^-1 1 / (1^T mu^-1 1),   dmu = sum_k (d mu / d x_k) xi_k
//   D mu D^T (k_i m_i) = D <dmu f>
//
// xi, f  beads' displacements and forces of the linear response; < > the mean over a period
// m_i    mean change of arm i, which makes the mean velocities of the three beads equal
// The mean tension k_i m_i is an internal force, so the weights w, the force distribution of a rigid swimmer,
// take it out of V. Dropping m_i instead and averaging beads with equal weights is not the periodic motion.
//
// Page: docs/method/second-order-perturbation.md.

namespace beadswim {

struct SecondOrderMotion {
  double velocity = 0;                  ///< V, towards bead 3 if positive [length/time]
  std::array<double, 2> arm_changes{};  ///< m_i = <L_i> - l_i [length]
  Stroke stroke;                        ///< first order
};

/// w: forces on the beads of a rigid swimmer that is pulled along its line, over their sum.
Eigen::Vector3d rigid_force_distribution(const Eigen::Matrix3d& mobility);

/// The periodic motion to second order in A and B, for the swimmer's mobility and slopes at rest.
SecondOrderMotion second_order_motion(const CollinearSwimmer& swimmer, const CollinearMobility& mobility);

/// Second-order velocity of arms that change by Re(x_i exp(i omega t)), whatever drives them [length/time].
double velocity_of_stroke(const Eigen::Vector2cd& arm, const CollinearMobility& mobility,
                          double angular_frequency);

/// C in V = C omega d_1 d_2 sin(delta_1 - delta_2), which holds in open space whatever drives the stroke
/// [1/length].
double geometry_factor(const CollinearMobility& mobility);

}  // namespace beadswim
