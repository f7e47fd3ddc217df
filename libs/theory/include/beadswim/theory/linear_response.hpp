#pragma once

#include <Eigen/Core>

#include "beadswim/theory/collinear_swimmer.hpp"
#include "beadswim/theory/stroke.hpp"

// Periodic motion of the beads about their positions at rest, to first order in the driving amplitude.
//
// Every quantity q varies as Re(q exp(i omega t)). The arm amplitudes x solve
//
//   (i omega Z + K) x = g,   Z = (D mu D^T)^-1,   D^T g = F = (-iA, iA + iB exp(i alpha), -iB exp(i alpha)).
//
//   D    [[-1, 1, 0], [0, -1, 1]], arm rates from bead velocities
//   mu   mobility at rest [time/mass]: real without inertia of the fluid, complex with it
//   K    diag(k_i + i omega c_i): springs and dashpots exert the forces -D^T K x [mass/time^2]
//
// The forces f on the beads sum to zero and follow from the motion, as do the bead displacements xi:
//
//   f = D^T Z i omega x,   xi = mu f / (i omega).
//
// This form avoids loss of significance for slow driving, where driving and spring forces nearly cancel.
//
// It holds for any radii, arms, stiffnesses, dashpots, A, B and alpha, without truncation in radius/arm.
// Page: docs/method/linear-response.md.

namespace beadswim {

/// Complex amplitudes of the periodic motion, to first order.
struct LinearResponse {
  Eigen::Vector2cd arm;           ///< x_i, change of arm i: Re(x_i exp(i omega t)) [length]
  Eigen::Vector3cd displacement;  ///< xi_i, displacement of bead i [length]
  Eigen::Vector3cd force;  ///< f: sum of driving, spring and dashpot forces on each bead [mass length/time^2]
};

/// Returns D: the rates of the two arms are D times the velocities of the three beads.
Eigen::Matrix<double, 2, 3> arm_rates();

/// Returns g: the driving (2.1) as complex tensions of the two arms, F = D^T g [mass length/time^2].
/// A sin(omega t) = Re(-iA exp(i omega t)).
Eigen::Vector2cd driving_tensions(const CollinearSwimmer& swimmer);

/// Returns Z, which relates the tensions of the two arms to their rates [mass/time].
Eigen::Matrix2cd arm_impedance(const Eigen::Matrix3cd& mobility);

/// Returns the arm amplitudes x by the equation above, with Z = `impedance` [length].
Eigen::Vector2cd driven_arms(const CollinearSwimmer& swimmer, const Eigen::Matrix2cd& impedance);

/// Returns displacements and forces of the beads if the arms change by `arm` [length] at `angular_frequency`
/// [rad/time].
LinearResponse response_to_stroke(const Eigen::Vector2cd& arm, const Eigen::Matrix3cd& mobility,
                                  double angular_frequency);

/// Returns the linear response of the swimmer to its driving.
LinearResponse linear_response(const CollinearSwimmer& swimmer, const Eigen::Matrix3cd& mobility);
LinearResponse linear_response(const CollinearSwimmer& swimmer, const Eigen::Matrix3d& mobility);

/// Returns the stroke in open space to first order, with the pair mobility `law` (oseen, rotne_prager).
Stroke first_order_stroke(const CollinearSwimmer& swimmer, PairLaw law);

}  // namespace beadswim
