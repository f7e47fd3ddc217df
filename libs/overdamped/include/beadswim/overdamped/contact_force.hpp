#pragma once

// Repulsion that keeps beads apart where nothing else would: point models know no film between surfaces.
//
//   F = strength (reach/gap - 1)    for gap < reach, else 0
//
// gap       between surfaces [length]
// reach     a fifth of the mean radius [length]
// strength  largest driving force in the scene: with it at half the reach beads bear their driving
//
// Straight below a twentieth of the reach, so that beads that do overlap part again. A model, not physics:
// where contacts decide, ask a resolved run. Page: docs/method/contact-repulsion.md.

namespace beadswim {

struct ContactForce {
  double force = 0;      ///< repulsion
  double stiffness = 0;  ///< -dF/dgap
};

inline ContactForce contact_force(double gap, double reach, double strength) {
  if (gap >= reach) return {};
  const double above = gap > reach / 20 ? gap : reach / 20;
  const double stiffness = strength * reach / (above * above);
  return {.force = strength * (reach / above - 1) + stiffness * (above - gap), .stiffness = stiffness};
}

}  // namespace beadswim
