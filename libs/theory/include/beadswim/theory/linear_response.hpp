#pragma once

#include <Eigen/Core>
#include <array>

#include "beadswim/collinear/collinear_mobility.hpp"
#include "beadswim/theory/collinear_swimmer.hpp"
#include "beadswim/theory/stroke.hpp"

// Motion of a swimmer about its relaxed shape to first order in the driving amplitude, and the mean motion
// that mean velocities of second order cause. The coordinates xi are the displacements of the beads: one per
// bead for beads on a line, three per bead in space.
//
//   first order    (i omega Z + K + i omega C) x = g,   f = D^T Z i omega x,   xi = mu f/(i omega)
//   second order   V = W^T u,   Z^-1 K m = D u
//                  Z = (D mu D^T)^-1,   W = mu^-1 R (R^T mu^-1 R)^-1
//
//   mu     mobility at rest [time/mass]: real without inertia of the fluid, complex with it
//   D      matrix that maps displacements to deformations; x = D xi. Arms on a line are
//          D = [[-1, 1, 0], [0, -1, 1]]
//   R      free motions, which deform no spring (D R = 0): on a line the translation (1, 1, 1)
//   K, C   stiffness [mass/time^2] and damping [mass/time] of the deformations
//   g      tensions by the driving: D^T g are the driving forces without their part on free motions
//   x, f   complex amplitudes q of Re(q exp(i omega t)): deformations [length], total forces on the beads
//   W      forces that tow the rigid swimmer: column k causes a unit rate of free motion k alone
//   u      mean velocities that the oscillation gives to the beads [length/time]
//   V, m   rates of the free motions; mean deformations [length], which balance u
//
// The forces D^T Z i omega x avoid loss of significance for slow driving, where driving and spring forces
// nearly cancel. The tensions K m are internal forces, which the weights W eliminate from V.
//
// On a line the mean velocities of second order are
//
//   u = <dmu f> = 1/2 Re sum_k (d mu / d x_k) conj(xi_k) f,   < > mean over a period
//
// where x_k is the position of bead k. The unweighted mean of the bead velocities, evaluated without m, is
// not the velocity of the periodic motion.
//
// The equations are valid for any radii, shape, springs and driving. They contain all orders in the ratio of
// radius to bead distance. Pages: docs/method/linear-response.md, docs/method/second-order-perturbation.md.

namespace beadswim {

/// Springs of a swimmer on its relaxed shape: the matrices D, R, K and C.
struct SpringNetwork {
  Eigen::MatrixXd deformations, free_motions, stiffness, damping;
};

/// Complex amplitudes of the periodic motion, to first order in the driving amplitude.
struct LinearResponse {
  Eigen::VectorXcd arm;           ///< x, changes of the arms or other deformations [length]
  Eigen::VectorXcd displacement;  ///< xi [length]
  Eigen::VectorXcd force;  ///< f: sum of driving, spring and dashpot forces on each bead [mass length/time^2]
};

/// Returns the response to the tensions g [mass length/time^2].
LinearResponse linear_response(const SpringNetwork& springs, const Eigen::MatrixXcd& mobility,
                               const Eigen::VectorXcd& tension, double angular_frequency);

/// Returns the displacements of the beads and the forces on them, if the deformations oscillate with the
/// complex amplitudes `arm` [length]. `deformations`: D.
LinearResponse response_to_stroke(const Eigen::MatrixXd& deformations, const Eigen::VectorXcd& arm,
                                  const Eigen::MatrixXcd& mobility, double angular_frequency);

/// Returns W, for a swimmer on a line the share of each bead in the force that tows it (column R = 1).
Eigen::MatrixXd towing_forces(const Eigen::MatrixXd& mobility, const Eigen::MatrixXd& free_motions);
Eigen::VectorXd towing_forces(const Eigen::MatrixXd& mobility);

/// Rates V of the free motions and mean deformations m.
struct MeanBalance {
  Eigen::VectorXd free_rates, deformation;
};

/// Returns the mean motion that balances the mean velocities u = `drift` [length/time].
MeanBalance balance_mean(const SpringNetwork& springs, const Eigen::MatrixXd& mobility,
                         const Eigen::VectorXd& drift);

/// Returns D of the two arms of a collinear swimmer.
Eigen::Matrix<double, 2, 3> arm_rates();

SpringNetwork springs_of(const CollinearSwimmer& swimmer);

/// Returns g of a collinear swimmer, F = D^T g with the driving forces F = (-iA, iA + iB exp(i alpha), -iB
/// exp(i alpha)) of equation (2.1) of Pickl et al. 2017 [mass length/time^2].
Eigen::Vector2cd driving_tensions(const CollinearSwimmer& swimmer);

/// Returns the mean power of the driving forces, P = 1/2 Re sum_i g_i (i omega x_i)* [mass length^2/time^3],
/// if the arm lengths vary by `stroke`. It is exact at any amplitude if `stroke` is the part of the motion
/// with the frequency of the driving, because the driving forces are pure sines.
double mean_power(const CollinearSwimmer& swimmer, const Stroke& stroke);

/// Returns omega d^2/l, the scale of velocities to second order in amplitude [length/time]. d: larger
/// amplitude of the arms, l: rest length of arm 1.
double second_order_scale(const CollinearSwimmer& swimmer, const Stroke& stroke);

/// Returns the linear response of the swimmer to its driving. `mobility`: of the beads at rest [time/mass];
/// complex with inertia of the fluid.
LinearResponse linear_response(const CollinearSwimmer& swimmer, const Eigen::Matrix3cd& mobility);
LinearResponse linear_response(const CollinearSwimmer& swimmer, const Eigen::Matrix3d& mobility);

/// Returns the arm amplitudes and phases in open space to first order in the driving amplitude, with the pair
/// mobility `law` (oseen or rotne_prager).
Stroke first_order_stroke(const CollinearSwimmer& swimmer, PairLaw law);

/// Returns the periodic motion to second order in the driving amplitudes A and B. `mobility`: mobility of the
/// beads at rest, with its derivatives.
PeriodicMotion second_order_motion(const CollinearSwimmer& swimmer, const CollinearMobility& mobility);

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
