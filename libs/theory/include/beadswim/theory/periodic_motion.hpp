#pragma once

#include <functional>

#include "beadswim/collinear/collinear_mobility.hpp"
#include "beadswim/theory/collinear_swimmer.hpp"
#include "beadswim/theory/stroke.hpp"

// Periodic motion at finite amplitude, computed by harmonic balance.
//
//   dx/dt = mu(x) f,   f = F(t) - D^T [K (D x - l) + C D dx/dt],   x_k(t) = X_k + p_k(t) + V t
//
//   x_k, X_k   position of bead k and its position at rest [length]
//   p_k        displacement with the period of the driving; its mean over beads and time is zero [length]
//   V          velocity of the swimmer [length/time]
//   mu, f, F   mobility [time/mass], total forces and driving forces on the beads [mass length/time^2]
//   K, C, l    diagonal matrices of stiffness k_i and damping c_i, rest lengths of the arms [length]
//   D          matrix that maps bead velocities to rates of the arm lengths (linear_response.hpp)
//
// Discretisation: p is represented by its values at M equidistant times (nodes), M odd. Its rate is the
// derivative of the trigonometric polynomial through these values. Newton's method solves the equations of
// motion at the nodes for p and V. M increases until the highest quarter of the harmonics is negligible.
//
// Velocity: the forces sum to zero, hence sum_k w_k(x) dx_k/dt = 0 at every time, where w_k is the share of
// bead k in the force that tows a rigid swimmer (linear_response.hpp). Therefore
//
//   V = - < sum_k (w_k(x) - w_k(X)) dp_k/dt >,    < >: mean over a period.
//
// This form avoids loss of significance for small strokes.
//
// Page: docs/method/harmonic-balance.md.

namespace beadswim {

/// Returns the mobility of the three beads for given bead positions.
using MobilityFunction = std::function<CollinearMobility(const LinePositions&)>;

/// Returns the periodic motion about the bead positions `rest`, at which the springs are relaxed. The gaps of
/// neighbouring beads must stay above `min_gap` [length].
/// Throws InputError if no such motion is found. The message states up to which fraction of the driving
/// amplitude a motion was found.
PeriodicMotion periodic_motion(const CollinearSwimmer& swimmer, const LinePositions& rest,
                               const MobilityFunction& mobility, double min_gap = 0);

/// Returns c, the leading relative change of the swimmer's velocity V in open space because the driving
/// amplitude is finite: V = V_2 (1 + c + ..), where V_2 is the velocity to second order in the driving
/// amplitude. For driving forces s A, s B the change is c s^2; c is evaluated at a small s, with a mobility
/// that is interpolated between a few bead configurations close to rest. Returns 0 if V_2 is zero within
/// roundoff, and NaN if beads touch or overlap at rest.
double finite_amplitude_change(const CollinearSwimmer& swimmer, const MobilityFunction& mobility);

/// Returns the smallest gap of neighbouring beads at `positions` [length].
double smallest_gap(const CollinearSwimmer& swimmer, const LinePositions& positions);

}  // namespace beadswim
