#pragma once

#include <array>
#include <functional>

#include "beadswim/mobility/collinear_mobility.hpp"
#include "beadswim/theory/collinear_swimmer.hpp"
#include "beadswim/theory/stroke.hpp"

// The periodic motion at finite amplitude, by harmonic balance.
//
//   dx/dt = mu(x) f,   f = F(t) - D^T [K (D x - l) + C D dx/dt],   x_k(t) = X_k + p_k(t) + V t
//
// p has the driving's period. It is known at M equidistant times (M odd), its rate by the derivative of the
// trigonometric polynomial through them, and the equations of motion at these times are solved by Newton's
// method for p and V. As the forces sum to zero, sum_k w_k(x) dx_k/dt = 0 at every time, w the force
// distribution of a rigid swimmer, so
//
//   V = - < sum_k (w_k(x) - w_k(X)) dp_k/dt >,
//
// which keeps its digits for small strokes. M grows until the highest quarter of the harmonics has died out.
//
// Page: docs/method/harmonic-balance.md.

namespace beadswim {

/// The mobility of the three beads wherever they are.
using MobilityAt = std::function<CollinearMobility(const LinePositions&)>;

struct PeriodicMotion {
  double velocity = 0;                ///< V, towards bead 3 if positive [length/time]
  std::array<double, 2> arm_means{};  ///< <L_i> [length]
  Stroke stroke;                      ///< first harmonic of the arms: their least-squares fit (4.1)
  double smallest_gap = 0;            ///< between surfaces of neighbouring beads, over the cycle [length]
  int nodes = 0;                      ///< M
};

/// The periodic motion about `rest`, places of the beads where the springs are relaxed. Neighbouring beads
/// must stay farther apart than `least_gap`, surface to surface [length].
/// Throws InputError, saying how far the driving can be turned up, where no such motion is found.
PeriodicMotion periodic_motion(const CollinearSwimmer& swimmer, const LinePositions& rest,
                               const MobilityAt& mobility, double least_gap = 0);

/// Smallest gap between surfaces of neighbouring beads at these places [length].
double smallest_gap(const CollinearSwimmer& swimmer, const LinePositions& positions);

}  // namespace beadswim
