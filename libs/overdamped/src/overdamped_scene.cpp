#include "beadswim/overdamped/overdamped_scene.hpp"

#include "beadswim/swimmers/rest_positions.hpp"

namespace beadswim {

std::vector<double> radii_of(const OverdampedScene& scene) {
  std::vector<double> radii;
  for (std::size_t s = 0; s < scene.swimmers.size(); ++s)
    for (const Bead& bead : scene.type_of(s).beads) radii.push_back(bead.radius);
  return radii;
}

Beads rest_places(const OverdampedScene& scene) {
  Beads places;
  for (std::size_t s = 0; s < scene.swimmers.size(); ++s) {
    const auto& [id, type, position, axis] = scene.swimmers[s];
    for (const Vec3& place : rest_positions(scene.types[type], position, axis)) places.push_back(place);
  }
  return places;
}

}  // namespace beadswim
