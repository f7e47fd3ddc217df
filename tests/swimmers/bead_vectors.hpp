#pragma once

#include <Eigen/Geometry>
#include <random>
#include <vector>

#include "beadswim/swimmers/swimmer_shape.hpp"

namespace beadswim {

/// Returns a matrix of these columns.
inline BeadVectors columns(const std::vector<Vec3>& vectors) {
  return columns_of_beads(vectors);
}

/// Returns a vector with normally distributed components of standard deviation 1.
inline Vec3 random_vector(std::mt19937& random) {
  std::normal_distribution<double> normal;
  return Vec3::NullaryExpr([&] { return normal(random); });
}

inline Eigen::Matrix3d random_rotation(std::mt19937& random) {
  std::uniform_real_distribution<double> angle(-3.1, 3.1);
  return Eigen::AngleAxisd(angle(random), random_vector(random).normalized()).toRotationMatrix();
}

}  // namespace beadswim
