#pragma once

#include <Eigen/Core>

#include "beadswim/theory/collinear_swimmer.hpp"
#include "beadswim/theory/stroke.hpp"

// First order in the driving amplitude: the periodic motion of the arms about their rest lengths.
//
// With D = [[-1, 1, 0], [0, -1, 1]] (arm rates from bead velocities), mu the mobility at rest, and every
// quantity Re(q exp(i omega t)), the springs and dashpots pull with -D^T K x, K = diag(k_i + i omega c_i),
// and
//
//   (i omega + D mu D^T K) x = D mu F,   F = (-iA, iA + iB exp(i alpha), -iB exp(i alpha)).
//
// Holds for any radii, arms, stiffnesses, dashpots, A, B, alpha, without truncation in radius/arm.
// Page: docs/method/second-order-perturbation.md.

namespace beadswim {

/// Complex amplitudes of the periodic motion to first order.
struct LinearResponse {
  Eigen::Vector2cd arm;    ///< x_i, change of arm i: Re(x_i exp(i omega t)) [length]
  Eigen::Vector3cd force;  ///< driving, springs and dashpots together, on beads 1, 2, 3 [mass length/time^2]
};

/// D: the rates of the two arms are D times the velocities of the three beads.
Eigen::Matrix<double, 2, 3> arm_rates();

LinearResponse linear_response(const CollinearSwimmer& swimmer, const Eigen::Matrix3d& mobility);

/// The stroke to first order, with pairs that interact by `law` (oseen, rotne_prager).
Stroke first_order_stroke(const CollinearSwimmer& swimmer, PairLaw law);

}  // namespace beadswim
