#pragma once

// Repulsion that keeps beads apart in models that do not resolve the lubrication film between surfaces.
//
//   F = strength (cutoff/gap - 1)    for gap < cutoff, else 0
//
//   gap       distance between the surfaces [length]
//   cutoff    a fifth of the mean radius [length]
//   strength  largest driving force in the scene [force]; at half the cutoff F equals this force
//
// Below a twentieth of the cutoff, F continues linearly with the gap, so that beads that overlap separate
// again. This is a numerical model without physical parameters. Where contacts determine the result, use a
// resolved run. Page: docs/method/contact-repulsion.md.

namespace beadswim {

struct ContactForce {
  double force = 0;      ///< F, repulsion [force]
  double stiffness = 0;  ///< -dF/dgap [force/length]
};

/// Evaluates F and -dF/dgap.
inline ContactForce contact_force(double gap, double cutoff, double strength) {
  if (gap >= cutoff) return {};
  const double above = gap > cutoff / 20 ? gap : cutoff / 20;
  const double stiffness = strength * cutoff / (above * above);
  return {.force = strength * (cutoff / above - 1) + stiffness * (above - gap), .stiffness = stiffness};
}

}  // namespace beadswim
