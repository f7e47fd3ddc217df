#pragma once

#include <vector>

#include "beadswim/core/vec3.hpp"
#include "beadswim/mobility/force_moments.hpp"

namespace beadswim {

/// Spheres as sources of flow and as its receivers: all spheres of a scene, then their mirror images at
/// free-slip walls, which are sources only.
struct ImagedSpheres {
  int order = 0;                ///< highest moment of the forces, 0 to 2 (force_moments.hpp)
  double viscosity = 0;         ///< dynamic [mass/(length time)]
  std::vector<double> radii;    ///< of all spheres and images [length]; 0: point forces
  Vec3 lengths = Vec3::Zero();  ///< edges of the periodic box with the images [length]; 0 in open space

  /// Returns the number of elements of the source or of the flow of a sphere.
  std::size_t elements() const { return 3 * derivative_count(order); }
};

}  // namespace beadswim
