#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace beadswim {

using Vec3 = Eigen::Vector3d;
using Index3 = Eigen::Array3i;

}  // namespace beadswim
