#pragma once

#include <numbers>

// Interface of pair laws. A pair law is a function that evaluates the mobility of two spheres along their
// common line. Units may be those of any coherent system.

namespace beadswim {

/// Mobility mu(r) of two spheres at the distance r of their centres, and its slope. mu is the velocity of one
/// sphere along the common line, per force on the other sphere along this line.
struct PairMobility {
  double value = 0;  ///< mu [time/mass]
  double slope = 0;  ///< d mu / d r [time/(mass length)]
};

/// Pair law: function that evaluates the mobility of two spheres along their common line. Arguments: radii
/// a_i and a_j, distance r of the centres [length], dynamic viscosity eta [mass/(length time)]. Exchanging
/// the radii does not change the mobility.
using PairLaw = PairMobility (*)(double radius_i, double radius_j, double distance, double viscosity);

/// Returns the Stokes mobility 1/(6 pi eta a) of a lone sphere of radius a = `radius` [time/mass], where eta
/// is the dynamic `viscosity`.
inline double self_mobility(double radius, double viscosity) {
  return 1 / (6 * std::numbers::pi * viscosity * radius);
}

}  // namespace beadswim
