#include "beadswim/swimmers/swimmer_shape.hpp"

#include <Eigen/Geometry>
#include <Eigen/SVD>
#include <limits>

namespace beadswim {

Eigen::Matrix3d shortest_turn(const Vec3& axis) {
  // Rotation about n = x cross axis, with cosine c = axis.x: 1 + [n] + [n]^2/(1 + c).
  Eigen::Matrix3d turn;
  const double c = axis.x(), sine_squared = axis.tail<2>().squaredNorm();
  if (c > 0 || sine_squared > 0) {
    const double w = c > 0 ? 1 / (1 + c) : (1 - c) / sine_squared;  // equal; the second is accurate near -x
    turn.col(1) = Vec3(-axis.y(), 1 - w * axis.y() * axis.y(), -w * axis.y() * axis.z());
    turn.col(2) = Vec3(-axis.z(), -w * axis.y() * axis.z(), 1 - w * axis.z() * axis.z());
  } else {
    turn.col(1) = -Vec3::UnitY();
    turn.col(2) = Vec3::UnitZ();
  }
  turn.col(0) = axis;
  return turn;
}

std::vector<Vec3> rest_positions(const SwimmerType& type, const Vec3& origin,
                                 const Eigen::Matrix3d& orientation) {
  std::vector<Vec3> positions;
  for (const BeadAtRest& bead : type.beads) {
    Vec3 place = origin;
    for (int a = 0; a < 3; ++a) {
      if (bead.at[a] != 0) place += bead.at[a] * orientation.col(a);
    }
    positions.push_back(place);
  }
  return positions;
}

Eigen::Matrix3d fitted_orientation(const SwimmerType& type, const BeadVectors& positions,
                                   const Eigen::Matrix3d& near) {
  const auto n = std::ssize(type.beads);
  Vec3 mean_at = Vec3::Zero();
  for (const BeadAtRest& bead : type.beads) mean_at += bead.at / static_cast<double>(n);
  const Vec3 mean_position = positions.rowwise().mean();
  Eigen::Matrix3d moment = Eigen::Matrix3d::Zero();
  for (int b = 0; b < n; ++b)
    moment += (positions.col(b) - mean_position) * (type.beads[b].at - mean_at).transpose();
  constexpr double weight_of_near = 1e-12;
  moment += (weight_of_near * moment.norm() + std::numeric_limits<double>::min()) * near;
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(moment, Eigen::ComputeFullU | Eigen::ComputeFullV);
  Eigen::Matrix3d left = svd.matrixU();
  if ((left * svd.matrixV().transpose()).determinant() < 0) left.col(2) *= -1;
  return left * svd.matrixV().transpose();
}

}  // namespace beadswim
