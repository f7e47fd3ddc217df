#pragma once

#include <optional>
#include <span>
#include <vector>

#include "beadswim/overdamped/contact_force.hpp"
#include "beadswim/overdamped/overdamped_scene.hpp"

namespace beadswim {

/// Two beads that repel each other, or a bead and its own mirror image.
struct Contact {
  int first = 0, second = 0;   ///< indices of the beads; equal for a bead and its own mirror image
  bool is_image = false;       ///< true if not the second bead itself but an image of it is in contact
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
  /// stretches the stiffest spring by the radius of the largest bead.
  double strength = 0;
  double largest_radius;  ///< radius of the largest bead [length]

  explicit ContactScale(const OverdampedScene& scene);
};

/// Finds all contacts of beads with the given radii and positions [length]. Each pair of beads is listed
/// once, with its nearest periodic image. A bead and its own mirror image behind a wall are a contact too.
std::vector<Contact> find_contacts(const ContactScale& scale, const Domain& domain,
                                   std::span<const double> radii, std::span<const Vec3> positions);

}  // namespace beadswim
