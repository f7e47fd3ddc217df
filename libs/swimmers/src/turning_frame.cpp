#include "beadswim/swimmers/turning_frame.hpp"

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

namespace beadswim {
namespace {

Vec3 rotation_vector(const Eigen::Matrix3d& rotation) {
  const Eigen::AngleAxisd turn(rotation);
  return turn.angle() * turn.axis();
}

}  // namespace

bool drives_turn_with_swimmer(const Driving& driving) {
  return driving.forces.empty() || driving.frame == DrivingFrame::body;
}

Eigen::Matrix3d rotation_by(const Vec3& vector) {
  const double angle = vector.norm();
  return angle > 0 ? Eigen::AngleAxisd(angle, vector / angle).toRotationMatrix()
                   : Eigen::Matrix3d(Eigen::Matrix3d::Identity());
}

Vec3 rotation_in_cycle(const Eigen::Matrix3d& whole, std::span<const Eigen::Matrix3d> parts) {
  Vec3 sum = Vec3::Zero();
  for (const Eigen::Matrix3d& part : parts) sum += rotation_vector(part);
  const Vec3 rest = rotation_vector(whole);
  // After nearly whole turns, the axis of the small rest says nothing about that of the turns.
  constexpr double roundoff = 1e-9, parallel = 0.99, turn = 2 * std::numbers::pi;
  Vec3 axis = rest.stableNormalized();
  if (rest.norm() < roundoff || std::abs(axis.dot(sum)) < parallel * sum.norm())
    axis = sum.stableNormalized();
  return rest + turn * std::round((sum - rest).dot(axis) / turn) * axis;
}

Vec3 displacement_in_cycle(std::span<const double> phases, std::span<const Vec3> places, const Vec3& turn,
                           const Vec3& carried) {
  const Eigen::Matrix3d change = rotation_by(turn) - Eigen::Matrix3d::Identity();
  const Vec3 whole = places.back() - places.front(), own = whole - carried;
  const auto deviation = [&](std::size_t k) -> Vec3 {
    const Vec3 moved = places[k] - places.front() - phases[k] * carried;
    return rotation_by(-phases[k] * turn) * (change * moved + own) - own;
  };
  Vec3 mean = Vec3::Zero();
  for (std::size_t k = 1; k < places.size(); ++k)
    mean += (phases[k] - phases[k - 1]) / 2 * (deviation(k - 1) + deviation(k));
  return whole + mean;
}

}  // namespace beadswim
