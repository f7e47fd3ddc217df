#pragma once

#include <numbers>

// Interface of the pair laws of spheres on a common line. Any coherent unit system.

namespace beadswim {

/// Mobility mu(r) of two spheres on their common line, and its slope. mu is the velocity of one sphere along
/// the line, per unit force on the other sphere along the line.
struct PairMobility {
  double value = 0;  ///< mu [time/mass]
  double slope = 0;  ///< d mu / d r [time/(mass length)]
};

/// A pair law. Arguments: radii a_i and a_j, distance r of the centres [length], dynamic viscosity eta
/// [mass/(length time)]. The mobility is symmetric in the radii.
using PairLaw = PairMobility (*)(double radius_i, double radius_j, double distance, double viscosity);

/// Returns the Stokes mobility of a lone sphere, 1 / (6 pi eta a) [time/mass].
inline double self_mobility(double radius, double viscosity) {
  return 1 / (6 * std::numbers::pi * viscosity * radius);
}

}  // namespace beadswim
