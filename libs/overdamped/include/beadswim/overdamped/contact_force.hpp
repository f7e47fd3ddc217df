#pragma once

// Repulsive force F between close beads in runs with a mobility model.
//
//   F = strength (cutoff/gap - 1)    for gap < cutoff, else 0
//
//   gap       distance between the surfaces [length]
//   cutoff    a fifth of the mean radius, or less (contacts.hpp) [length]
//   strength  largest driving force in the scene [force]; F equals it at gap = cutoff/2
//
// For gap < cutoff/20, F continues linearly with the gap, so that overlapping beads separate again. F is a
// numerical model without physical parameters. If contacts determine the result, use a resolved run (on
// the lattice) instead. Page: docs/method/contact-repulsion.md.

namespace beadswim {

struct ContactForce {
  double force = 0;      ///< F, repulsion [force]
  double stiffness = 0;  ///< -dF/dgap [force/length]
};

/// Evaluates the repulsion F [force] and its stiffness -dF/dgap [force/length] for a gap and a cutoff
/// [length]. strength: F at gap = cutoff/2 [force].
inline ContactForce contact_force(double gap, double cutoff, double strength) {
  if (gap >= cutoff) return {};
  const double above = gap > cutoff / 20 ? gap : cutoff / 20;
  const double stiffness = strength * cutoff / (above * above);
  return {.force = strength * (cutoff / above - 1) + stiffness * (above - gap), .stiffness = stiffness};
}

}  // namespace beadswim
