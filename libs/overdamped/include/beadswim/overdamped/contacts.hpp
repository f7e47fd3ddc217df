#pragma once

#include <optional>
#include <span>
#include <vector>

#include "beadswim/overdamped/contact_force.hpp"
#include "beadswim/overdamped/overdamped_scene.hpp"

namespace beadswim {

/// Two beads, or a bead and its mirror image, that repel each other.
struct Contact {
  int first = 0, second = 0;   ///< indices of the beads; equal for a bead and its image behind a wall
  bool is_image = false;       ///< the second bead is represented by a periodic or mirror image
  Vec3 normal = Vec3::Zero();  ///< unit vector from the second bead to the first
  double gap = 0;              ///< between the surfaces of the beads, or of bead and image [length]
  double cutoff = 0;           ///< gap at which the repulsion begins [length]
  ContactForce law;            ///< repulsion at this gap
};

/// Range and strength of the repulsion in a scene.
struct ContactScale {
  double cutoff_per_radius = 0.2;  ///< cutoff, divided by the mean radius of the two beads
  /// Largest driving force [force]. Without driving: the force that stretches the stiffest spring by the
  /// largest radius.
  double strength = 0;
  double largest_radius;  ///< [length]

  explicit ContactScale(const OverdampedScene& scene);
};

/// Finds all contacts at the given positions. Each pair is listed once, with its nearest image. A bead's own
/// images behind walls are included.
std::vector<Contact> find_contacts(const ContactScale& scale, const std::optional<Box>& box,
                                   std::span<const double> radii, std::span<const Vec3> positions);

}  // namespace beadswim
