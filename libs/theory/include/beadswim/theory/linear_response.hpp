#pragma once

#include <Eigen/Core>

#include "beadswim/theory/collinear_swimmer.hpp"
#include "beadswim/theory/stroke.hpp"

// First order in the driving amplitude: the periodic motion of the beads about their places at rest.
//
// With D = [[-1, 1, 0], [0, -1, 1]] (arm rates from bead velocities), mu the mobility at rest, and every
// quantity Re(q exp(i omega t)), the springs and dashpots pull with -D^T K x, K = diag(k_i + i omega c_i),
// and the arms answer
//
//   (i omega Z + K) x = g,   Z = (D mu D^T)^-1,   D^T g = F = (-iA, iA + iB exp(i alpha), -iB exp(i alpha)).
//
// The forces on the beads sum to zero, so they are those that this motion takes,
//
//   f = D^T Z i omega x,   beads displaced by xi = mu f / (i omega),
//
// a form that keeps its digits for slow driving too, where driving and springs all but cancel.
// mu is real without inertia of the fluid, complex with it.
//
// Holds for any radii, arms, stiffnesses, dashpots, A, B, alpha, without truncation in radius/arm.
// Page: docs/method/linear-response.md.

namespace beadswim {

/// Complex amplitudes of the periodic motion to first order.
struct LinearResponse {
  Eigen::Vector2cd arm;           ///< x_i, change of arm i: Re(x_i exp(i omega t)) [length]
  Eigen::Vector3cd displacement;  ///< xi_i, displacement of bead i [length]
  Eigen::Vector3cd force;  ///< driving, springs and dashpots together, on beads 1, 2, 3 [mass length/time^2]
};

/// D: the rates of the two arms are D times the velocities of the three beads.
Eigen::Matrix<double, 2, 3> arm_rates();

/// g: (2.1) as complex amplitudes of tensions on the two arms, F = D^T g; A sin(omega t) = Re(-iA exp(i omega
/// t)).
Eigen::Vector2cd driving_tensions(const CollinearSwimmer& swimmer);

/// Z: tensions on the two arms over their rates [mass/time].
Eigen::Matrix2cd arm_impedance(const Eigen::Matrix3cd& mobility);

/// x: the arms' answer to the driving against this impedance, springs and dashpots.
Eigen::Vector2cd driven_arms(const CollinearSwimmer& swimmer, const Eigen::Matrix2cd& impedance);

/// How the beads move, and the forces on them, when the arms change by `arm` at `angular_frequency`.
LinearResponse response_to_stroke(const Eigen::Vector2cd& arm, const Eigen::Matrix3cd& mobility,
                                  double angular_frequency);

/// The swimmer's answer to its driving.
LinearResponse linear_response(const CollinearSwimmer& swimmer, const Eigen::Matrix3cd& mobility);
LinearResponse linear_response(const CollinearSwimmer& swimmer, const Eigen::Matrix3d& mobility);

/// The stroke to first order, with pairs that interact by `law` (oseen, rotne_prager).
Stroke first_order_stroke(const CollinearSwimmer& swimmer, PairLaw law);

}  // namespace beadswim
