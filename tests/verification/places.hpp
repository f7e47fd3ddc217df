#pragma once

#include <vector>

#include "beadswim/core/vec3.hpp"

namespace beadswim::verification {

/// A simple-cubic array of spheres on the lattice.
struct CubicArray {
  double phi = 0;     ///< volume fraction
  int edge = 0;       ///< of the unit cell [cell]
  double radius = 0;  ///< such that phi is exact [cell]
};

/// The one whose spheres come nearest to so many cells a diameter.
CubicArray cubic_array(double phi, double cells_per_diameter);

/// Random places within a cell, the same for every case and scheme [cell].
std::vector<Vec3> random_places(int count);

}  // namespace beadswim::verification
