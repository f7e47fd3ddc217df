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
  bool is_image = false;       ///< the second bead acts by a periodic or mirror image
  Vec3 normal = Vec3::Zero();  ///< unit vector from the second bead to the first
  double gap = 0;              ///< distance between the surfaces of the beads, or of bead and image [length]
  double cutoff = 0;           ///< gap below which the beads repel each other [length]
  ContactForce law;            ///< force and stiffness at this gap
};

/// Range and strength of the repulsion in a scene.
struct ContactScale {
  double cutoff_per_radius = 0.2;  ///< cutoff of the gap, divided by the mean radius of the two beads
  /// Largest driving force [force]. Without driving, it is the force that stretches the stiffest spring by
  /// the largest radius.
  double strength = 0;
  double largest_radius;  ///< [length]

  explicit ContactScale(const OverdampedScene& scene);
};

/// Finds all contacts at the given positions. Each pair of beads is listed once, with its nearest periodic
/// image. A bead and its own mirror image behind a wall are a contact too.
std::vector<Contact> find_contacts(const ContactScale& scale, const std::optional<Box>& box,
                                   std::span<const double> radii, std::span<const Vec3> positions);

}  // namespace beadswim
