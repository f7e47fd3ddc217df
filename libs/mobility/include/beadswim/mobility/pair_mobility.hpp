#pragma once

#include <numbers>

// What every pair law of spheres on a common line answers to. Any coherent unit system.

namespace beadswim {

/// Two spheres on their common line: the velocity of one along the line per unit force on the other along
/// the line, mu(r), and its slope d mu / d r at the same distance.
struct PairMobility {
  double value = 0;  ///< mu [time/mass]
  double slope = 0;  ///< d mu / d r [time/(mass length)]
};

/// A pair law: radii a_i and a_j, distance r of the centres [length], dynamic viscosity eta
/// [mass/(length time)]. Symmetric in the two radii.
using PairLaw = PairMobility (*)(double radius_i, double radius_j, double distance, double viscosity);

/// Stokes: velocity of a lone sphere per unit force on it, 1 / (6 pi eta a) [time/mass].
inline double self_mobility(double radius, double viscosity) {
  return 1 / (6 * std::numbers::pi * viscosity * radius);
}

}  // namespace beadswim
