#pragma once

#include <string>
#include <vector>

#include "beadswim/core/vec3.hpp"
#include "beadswim/coupling/bead_scheme.hpp"
#include "beadswim/io/json.hpp"

namespace beadswim::verification {

/// A simple-cubic array of spheres on the lattice.
struct CubicArray {
  double phi = 0;     ///< volume fraction
  int edge = 0;       ///< edge of the unit cell [cell]
  double radius = 0;  ///< radius for which phi is exact [cell]
};

/// Returns the array in which the diameter of the spheres is closest to this number of cells.
CubicArray cubic_array(double phi, double cells_per_diameter);

/// Returns the record of a quantity that was measured in an array at several positions of the sphere: mean,
/// error and spread.
Json array_record(const std::string& name, BeadScheme scheme, double relaxation_time, const CubicArray& array,
                  int cells_per_diameter, const std::vector<double>& measured, double reference);

/// Returns random positions within a cell, the same for every case and scheme [cell].
std::vector<Vec3> random_places(int count);

}  // namespace beadswim::verification
