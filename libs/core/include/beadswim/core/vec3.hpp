#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <span>

namespace beadswim {

using Vec3 = Eigen::Vector3d;
using Index3 = Eigen::Array3i;

/// Returns the unit vector along an axis (0, 1, 2).
inline Index3 unit_vector(int axis) {
  return {axis == 0, axis == 1, axis == 2};
}

/// Returns the smallest axis-aligned box that contains all given points. There must be at least one point.
inline Eigen::AlignedBox3d bounding_box(std::span<const Vec3> points) {
  Eigen::AlignedBox3d box(points.front());
  for (const Vec3& point : points) box.extend(point);
  return box;
}

}  // namespace beadswim
