#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace beadswim {

using Vec3 = Eigen::Vector3d;
using Index3 = Eigen::Array3i;

/// Returns the unit vector along an axis (0, 1, 2).
inline Index3 unit_vector(int axis) {
  return {axis == 0, axis == 1, axis == 2};
}

}  // namespace beadswim
