#pragma once

#include "beadswim/core/vec3.hpp"
#include "beadswim/lattice/d3q19.hpp"

namespace beadswim {

/// Returns the vector from a cell to the next cell along direction i [cell].
inline Index3 lattice_vector(int i) {
  const auto& c = d3q19::velocity[i];
  return {c[0], c[1], c[2]};
}

/// Returns the velocity c_i of direction i [cell/step].
inline Vec3 velocity_of(int i) {
  return lattice_vector(i).cast<double>().matrix();
}

}  // namespace beadswim
