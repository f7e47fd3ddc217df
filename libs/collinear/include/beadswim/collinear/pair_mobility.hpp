#pragma once

#include <numbers>

#include "beadswim/core/vec3.hpp"

// Interface of pair laws, which evaluate the mobility of two spheres. Units may be those of any coherent
// system.

namespace beadswim {

/// Mobility tensor of two spheres, isotropic I + axial n n^T [time/mass], where I is the unit tensor and n
/// the unit vector along the line of centres.
struct PairTensor {
  double isotropic = 0, axial = 0;

  PairTensor operator-(const PairTensor& other) const {
    return {isotropic - other.isotropic, axial - other.axial};
  }
  /// Returns the velocity that `force` on one sphere gives to the other sphere. `separation` is the vector
  /// between the centres, `distance` its length.
  Vec3 apply(const Vec3& separation, double distance, const Vec3& force) const {
    if (distance == 0) return isotropic * force;
    return isotropic * force + (axial * separation.dot(force) / (distance * distance)) * separation;
  }
};

/// Mobility mu(r) of two spheres at the distance r of their centres, and its slope. mu is the velocity of one
/// sphere along the common line, per force on the other sphere along this line.
struct PairMobility {
  double value = 0;  ///< mu [time/mass]
  double slope = 0;  ///< d mu / d r [time/(mass length)]
};

/// Returns the component along the line of centres of a mobility tensor at the distance r [length], and its
/// slope. The flow of a force has no divergence, so that the slope is -2 axial/r.
inline PairMobility along_line(const PairTensor& mu, double r) {
  return {.value = mu.isotropic + mu.axial, .slope = mu.axial == 0 ? 0 : -2 * mu.axial / r};
}

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
