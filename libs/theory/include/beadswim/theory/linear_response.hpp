#pragma once

#include <Eigen/Core>

#include "beadswim/theory/collinear_swimmer.hpp"
#include "beadswim/theory/stroke.hpp"

// Periodic motion of the beads about their positions at rest, to first order in the driving amplitude.
//
// Every quantity q varies as Re(q exp(i omega t)). The complex arm amplitudes x solve
//
//   (i omega Z + K) x = g,   Z = (D mu D^T)^-1,   D^T g = F = (-iA, iA + iB exp(i alpha), -iB exp(i alpha)).
//
//   D    [[-1, 1, 0], [0, -1, 1]]: maps bead velocities to rates of the arm lengths
//   F    driving forces on the beads, equation (2.1) of Pickl et al. 2017 [mass length/time^2]
//   g    tensions of the two arms by the driving [mass length/time^2]
//   mu   mobility at rest [time/mass]: real without inertia of the fluid, complex with it
//   K    diag(k_i + i omega c_i): springs and dashpots exert the forces -D^T K x [mass/time^2]
//
// The total forces f on the beads sum to zero. They and the bead displacements xi follow from the arm
// amplitudes:
//
//   f = D^T Z i omega x,   xi = mu f / (i omega).
//
// This form avoids loss of significance for slow driving, where driving and spring forces nearly cancel.
//
// The equations are valid for any radii, arms, stiffnesses, dashpots, A, B and alpha. They contain all orders
// in the ratio of radius to arm length. Page: docs/method/linear-response.md.

namespace beadswim {

/// Complex amplitudes of the periodic motion, to first order in the driving amplitude.
struct LinearResponse {
  Eigen::Vector2cd arm;           ///< x_i, change of arm i: Re(x_i exp(i omega t)) [length]
  Eigen::Vector3cd displacement;  ///< xi_i, displacement of bead i [length]
  Eigen::Vector3cd force;  ///< f: sum of driving, spring and dashpot forces on each bead [mass length/time^2]
};

/// Returns D, which maps the velocities of the three beads to the rates of the two arm lengths.
Eigen::Matrix<double, 2, 3> arm_rates();

/// Returns g, the complex tensions of the two arms by the driving: F = D^T g [mass length/time^2]. The
/// driving forces are sines, and A sin(omega t) = Re(-iA exp(i omega t)).
Eigen::Vector2cd driving_tensions(const CollinearSwimmer& swimmer);

/// Returns Z = (D mu D^T)^-1, which maps the rates of the two arm lengths to the tensions of the arms
/// [mass/time]. mu = `mobility` is the matrix of the three beads [time/mass], D = arm_rates().
Eigen::Matrix2cd arm_impedance(const Eigen::Matrix3cd& mobility);

/// Returns the complex arm amplitudes x [length] under the driving, the solution of (i omega Z + K) x = g,
/// where Z is `impedance` [mass/time], K the stiffness of springs and dashpots, and g = driving_tensions().
Eigen::Vector2cd driven_arms(const CollinearSwimmer& swimmer, const Eigen::Matrix2cd& impedance);

/// Returns the mean power of the driving forces, P = 1/2 Re sum_i g_i (i omega x_i)* [mass length^2/time^3],
/// if the arm lengths vary by `stroke`. It is exact at any amplitude if `stroke` is the part of the motion
/// with the frequency of the driving, because the driving forces are pure sines.
double mean_power(const CollinearSwimmer& swimmer, const Stroke& stroke);

/// Returns the displacements of the beads and the forces on them, if the arms oscillate with the complex
/// amplitudes `arm` [length] at `angular_frequency` [rad/time]. `mobility`: of the beads at rest [time/mass].
LinearResponse response_to_stroke(const Eigen::Vector2cd& arm, const Eigen::Matrix3cd& mobility,
                                  double angular_frequency);

/// Returns the linear response of the swimmer to its driving. `mobility`: of the beads at rest [time/mass];
/// complex with inertia of the fluid.
LinearResponse linear_response(const CollinearSwimmer& swimmer, const Eigen::Matrix3cd& mobility);
LinearResponse linear_response(const CollinearSwimmer& swimmer, const Eigen::Matrix3d& mobility);

/// Returns the arm amplitudes and phases in open space to first order in the driving amplitude, with the pair
/// mobility `law` (oseen or rotne_prager).
Stroke first_order_stroke(const CollinearSwimmer& swimmer, PairLaw law);

}  // namespace beadswim
