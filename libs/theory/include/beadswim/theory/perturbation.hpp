#pragma once

#include <Eigen/Core>

#include "beadswim/collinear/collinear_mobility.hpp"
#include "beadswim/theory/collinear_swimmer.hpp"
#include "beadswim/theory/stroke.hpp"

// Motion of a collinear swimmer to second order in the driving amplitude. The mean velocities u = <dmu f> of
// the beads cause the velocity V and the mean changes m_i of the arm lengths, as in linear_response.hpp.
//
//   <dmu f> = 1/2 Re sum_k (d mu / d x_k) conj(xi_k) f
//
//   mu     mobility at rest [time/mass];  dmu  its change by the bead displacements;  x_k  positions of the
//   beads xi, f  displacements and forces of the beads in the linear response < >    mean over a period
//
// The unweighted mean of the bead velocities, evaluated without m_i, is not the velocity of the periodic
// motion.
//
// Page: docs/method/second-order-perturbation.md.

namespace beadswim {

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
