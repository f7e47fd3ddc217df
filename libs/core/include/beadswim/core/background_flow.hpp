#pragma once

#include <Eigen/Core>

#include "beadswim/core/vec3.hpp"

namespace beadswim {

/// Steady linear flow u = velocity + velocity_gradient x of the fluid without spheres; x is the position.
struct BackgroundFlow {
  Vec3 velocity = Vec3::Zero();                                 ///< at the origin [length/time]
  Eigen::Matrix3d velocity_gradient = Eigen::Matrix3d::Zero();  ///< row c: gradient of u_c [1/time]

  bool is_zero() const { return velocity.isZero(0) && velocity_gradient.isZero(0); }
  Vec3 at(const Vec3& position) const { return velocity + velocity_gradient * position; }

  bool operator==(const BackgroundFlow&) const = default;
};

}  // namespace beadswim
