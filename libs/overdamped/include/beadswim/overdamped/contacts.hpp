#pragma once

#include <optional>
#include <span>
#include <vector>

#include "beadswim/overdamped/overdamped_scene.hpp"

// Repulsive force F between close beads in runs with a mobility model.
//
//   F = strength (cutoff/gap - 1)    for gap < cutoff, else 0
//
//   gap       distance between the surfaces [length]
//   cutoff    a fifth of the mean radius, or less (ContactScale) [length]
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

/// Two beads that repel each other, or a bead and its own mirror image.
struct Contact {
  int first = 0, second = 0;   ///< indices of the beads; equal for a bead and its own mirror image
  bool is_own = false;         ///< true for two beads of one swimmer, neither of them an image
  Vec3 normal = Vec3::Zero();  ///< unit vector from the second bead to the first
  double gap = 0;              ///< distance between the surfaces of the beads, or of bead and image [length]
  double cutoff = 0;           ///< gap below which the beads repel each other [length]
  ContactForce law;            ///< force and stiffness at this gap
};

/// Range and strength of the repulsion between close beads in a scene.
struct ContactScale {
  /// Cutoff of the gap, divided by the mean radius of the two beads.
  double cutoff_per_radius = 0.2;
  /// Cutoff for two beads of one swimmer, divided by their mean radius; one element per bead of the scene. It
  /// is at most half of the smallest gap of the swimmer at rest, so that its beads do not repel each other
  /// at rest.
  std::vector<double> own_cutoff_per_radius;
  std::vector<int> swimmer;      ///< index of the swimmer of each bead of the scene
  double min_cutoff_per_radius;  ///< minimum of all cutoffs, divided by the mean radius
  /// Strength of the repulsion: the largest driving force [force]. Without driving, it is the force that
  /// stretches the stiffest spring by the radius of the largest bead. With thermal noise it is at least 20 kT
  /// divided by the smallest cutoff.
  double strength = 0;
  double largest_radius;  ///< radius of the largest bead [length]

  explicit ContactScale(const OverdampedScene& scene);
};

/// Finds all contacts of beads with the given radii and positions [length]. Each pair of beads is listed
/// once, with its nearest periodic image. A bead and its own mirror image behind a wall are a contact too.
std::vector<Contact> find_contacts(const ContactScale& scale, const Domain& domain,
                                   std::span<const double> radii, std::span<const Vec3> positions);

}  // namespace beadswim
