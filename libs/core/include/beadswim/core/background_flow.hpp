#pragma once

#include <Eigen/Core>
#include <numbers>

#include "beadswim/core/fields.hpp"
#include "beadswim/core/vec3.hpp"

namespace beadswim {

/// Steady linear flow u = velocity + velocity_gradient x of the fluid without spheres; x is the position.
struct BackgroundFlow {
  Vec3 velocity = Vec3::Zero();                                 ///< at the origin [length/time]
  Eigen::Matrix3d velocity_gradient = Eigen::Matrix3d::Zero();  ///< row c: gradient of u_c [1/time]

  bool is_zero() const { return velocity.isZero(0) && velocity_gradient.isZero(0); }
  Vec3 at(const Vec3& position) const { return velocity + velocity_gradient * position; }
  /// Returns sqrt(2 E:E) of the rate-of-strain tensor E, the shear rate in simple shear [1/time].
  double shear_rate() const {
    return (velocity_gradient + velocity_gradient.transpose()).norm() / std::numbers::sqrt2;
  }

  bool operator==(const BackgroundFlow&) const = default;

  BEADSWIM_FIELDS(velocity_gradient, velocity)
};

}  // namespace beadswim
