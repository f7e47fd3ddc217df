#pragma once

#include <optional>
#include <span>
#include <vector>

#include "beadswim/overdamped/contact_force.hpp"
#include "beadswim/overdamped/overdamped_scene.hpp"

namespace beadswim {

/// Two beads, or a bead and its mirror image, so close that they repel each other.
struct Contact {
  int first = 0, second = 0;   ///< beads; the same: with its image behind a wall
  bool is_image = false;       ///< of the second, in the box
  Vec3 normal = Vec3::Zero();  ///< from the second to the first
  double gap = 0;              ///< between surfaces, also of bead and image [length]
  double reach = 0;            ///< of the repulsion [length]
  ContactForce law;
};

/// Range and strength of the scene's repulsion.
struct ContactScale {
  double share = 0.2;  ///< reach over the mean radius
  double strength =
      0;  ///< largest driving force; where there is none, that which stretches a spring by a radius
  double largest_radius;  ///< [length]

  explicit ContactScale(const OverdampedScene& scene);
};

/// All at these places, of each pair once: the nearest image, and a bead's own behind each wall.
std::vector<Contact> find_contacts(const ContactScale& scale, const std::optional<Box>& box,
                                   std::span<const double> radii, std::span<const Vec3> positions);

}  // namespace beadswim
