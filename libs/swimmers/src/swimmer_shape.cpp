#include "beadswim/swimmers/swimmer_shape.hpp"

#include <Eigen/SVD>
#include <algorithm>
#include <numbers>
#include <optional>

#include "beadswim/swimmers/hinges.hpp"

namespace beadswim {
namespace {

/// Returns the direction of the line on which all beads are, or nothing if there is none. at: centres at
/// rest, relative to their mean.
std::optional<Vec3> common_line(const BeadVectors& at) {
  Eigen::Index farthest = 0;
  const double reach = at.colwise().norm().maxCoeff(&farthest);
  if (reach == 0) return std::nullopt;
  const Vec3 direction = at.col(farthest) / reach;
  constexpr double roundoff = 1e-9;
  for (const auto& place : at.colwise())
    if (direction.cross(Vec3(place)).norm() > roundoff * reach) return std::nullopt;
  return direction;
}

/// Returns the reach of spheres about the beads. radius_of(bead): radius of the sphere.
Reach reach_of_spheres(const SwimmerType& type, int a, auto&& radius_of) {
  Reach reach;
  for (const BeadAtRest& bead : type.beads) {
    reach.ahead = std::max(reach.ahead, bead.at[a] + radius_of(bead));
    reach.behind = std::max(reach.behind, radius_of(bead) - bead.at[a]);
  }
  return reach;
}

}  // namespace

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

Eigen::Quaterniond shortest_turn(const Vec3& from, const Vec3& to) {
  return Eigen::Quaterniond::FromTwoVectors(from, to);
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

double distance_at_rest(const SwimmerType& type, int i, int j) {
  return (type.beads[j].at - type.beads[i].at).norm();
}

double contact_distance(const SwimmerType& type, int i, int j) {
  return type.beads[i].radius + type.beads[j].radius;
}

bool is_straight(const SwimmerType& type) {
  return std::ranges::all_of(type.beads,
                             [](const BeadAtRest& bead) { return bead.at.y() == 0 && bead.at.z() == 0; });
}

Reach reach_of_centres(const SwimmerType& type, int a) {
  return reach_of_spheres(type, a, [](const Bead&) { return 0.0; });
}

Reach reach_of_surfaces(const SwimmerType& type, int a) {
  return reach_of_spheres(type, a, [](const Bead& bead) { return bead.radius; });
}

double angle_between(const Angle& angle, std::span<const Vec3> positions) {
  const auto [i, j, l] = angle.beads;
  const Vec3 first = positions[j] - positions[i], second = positions[l] - positions[j];
  return std::atan2(first.cross(second).norm(), first.dot(second));
}

double angle_at_rest(const SwimmerType& type, const Angle& angle) {
  const std::vector<Vec3> at = rest_positions(type, Vec3::Zero(), Eigen::Matrix3d::Identity());
  const double theta = angle_between(angle, at);
  constexpr double roundoff = 1e-9;
  if (theta < roundoff) return 0;
  if (angle.normal) {
    const auto [i, j, l] = angle.beads;
    return std::copysign(theta, angle.normal->dot((at[j] - at[i]).cross(at[l] - at[j])));
  }
  return theta > std::numbers::pi - roundoff ? std::numbers::pi : theta;
}

Eigen::Matrix3d fitted_orientation(const SwimmerType& type, const BeadVectors& positions,
                                   const Eigen::Matrix3d& near) {
  const auto n = std::ssize(type.beads);
  BeadVectors at(3, n);
  for (int b = 0; b < n; ++b) at.col(b) = type.beads[b].at;
  at.colwise() -= Vec3(at.rowwise().mean());
  const Eigen::Matrix3d moment = (positions.colwise() - Vec3(positions.rowwise().mean())) * at.transpose();
  if (const std::optional<Vec3> line = common_line(at)) {
    const Vec3 direction = (moment * *line).normalized();
    return shortest_turn(near * *line, direction).toRotationMatrix() * near;
  }
  if (n == 1) return near;
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(moment, Eigen::ComputeFullU | Eigen::ComputeFullV);
  Eigen::Matrix3d left = svd.matrixU();
  if ((left * svd.matrixV().transpose()).determinant() < 0) left.col(2) *= -1;
  return left * svd.matrixV().transpose();
}

Vec3 axis_of(const SwimmerType& type, std::span<const Vec3> positions,
             const Eigen::Matrix3d& initial_orientation) {
  if (type.beads.size() > 1 && is_straight(type)) {
    const auto x = [](const BeadAtRest& bead) { return bead.at.x(); };
    const auto [first, last] = std::ranges::minmax_element(type.beads, {}, x);
    return (positions[last - type.beads.begin()] - positions[first - type.beads.begin()]).normalized();
  }
  return fitted_orientation(type, columns_of_beads(positions), initial_orientation).col(0);
}

}  // namespace beadswim
