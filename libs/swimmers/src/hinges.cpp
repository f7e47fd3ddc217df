#include "beadswim/swimmers/hinges.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <vector>

#include "beadswim/core/dense_systems.hpp"
#include "beadswim/swimmers/swimmer_forces.hpp"

namespace beadswim {
namespace {

/// Returns the matrix [v] of the cross product, [v] x = v x x.
Eigen::Matrix3d cross_matrix(const Vec3& v) {
  Eigen::Matrix3d matrix;
  matrix << 0, -v.z(), v.y(), v.z(), 0, -v.x(), -v.y(), v.x(), 0;
  return matrix;
}

BeadVectors relative_to_mean(const BeadVectors& beads) {
  return beads.colwise() - Vec3(beads.rowwise().mean());
}

/// Returns for each bead whether bonds join it to the third bead of an angle without its second bead.
std::vector<bool> beads_beyond(const SwimmerType& type, const Angle& angle) {
  std::vector<bool> beyond(type.beads.size());
  beyond[angle.beads[2]] = true;
  for (bool grows = true; grows;) {
    grows = false;
    for (const Bond& bond : type.bonds) {
      const auto [i, j] = bond.beads;
      if (i == angle.beads[1] || j == angle.beads[1] || beyond[i] == beyond[j]) continue;
      beyond[i] = beyond[j] = grows = true;
    }
  }
  return beyond;
}

/// The bending vector kappa = phi u x w, phi = theta/sin(theta), and its derivatives by u and w:
/// d kappa = phi d(u x w) - psi (u x w) d(u . w), psi = (1 - phi cos(theta))/sin(theta)^2.
struct Bending {
  Vec3 vector;
  Eigen::Matrix3d by_first, by_second;
};

Bending bending(const AngleSides& sides) {
  const auto& [direction, length, cosine, sine] = sides;
  const Vec3 &u = direction[0], &w = direction[1], across = u.cross(w);
  constexpr double smallest_sine = 1e-12;
  double phi = 1, psi = 1.0 / 3;  // limits at theta = 0
  if (sine > smallest_sine) {
    phi = std::atan2(sine, cosine) / sine;
    psi = (1 - phi * cosine) / (sine * sine);
  }
  return {.vector = phi * across,
          .by_first = -phi * cross_matrix(w) - psi * across * w.transpose(),
          .by_second = phi * cross_matrix(u) - psi * across * u.transpose()};
}

}  // namespace

bool has_hinges(const SwimmerType& type) {
  return std::ranges::any_of(type.angles, [](const Angle& angle) { return angle.normal.has_value(); });
}

bool separates_beads(const SwimmerType& type, const Angle& angle) {
  return !beads_beyond(type, angle)[angle.beads[0]];
}

SwimmerType at_rest_angles(SwimmerType type, double time) {
  if (!has_hinges(type)) return type;
  const BeadVectors at = columns_of_beads(rest_positions(type, Vec3::Zero(), Eigen::Matrix3d::Identity()));
  BeadVectors beads = at;
  for (std::size_t k = 0; k < type.angles.size(); ++k) {
    const Angle& angle = type.angles[k];
    if (!angle.normal) continue;
    const double change = rest_angle(type, k, time) - angle.normal->dot(bending(sides_of(angle, at)).vector);
    const std::vector<bool> beyond = beads_beyond(type, angle);
    const Vec3 pivot = beads.col(angle.beads[1]);
    for (int b = 0; b < beads.cols(); ++b) {
      const Eigen::AngleAxisd turn(beyond[b] ? change / 2 : -change / 2, *angle.normal);
      if (b != angle.beads[1]) beads.col(b) = pivot + turn * (Vec3(beads.col(b)) - pivot);
    }
  }
  const Vec3 shift = at.rowwise().mean() - beads.rowwise().mean();
  for (std::size_t b = 0; b < type.beads.size(); ++b) type.beads[b].at = Vec3(beads.col(b)) + shift;
  return type;
}

HingeFit fit_hinges(const SwimmerType& type, double time, const BeadVectors& positions) {
  const SwimmerType shaped = at_rest_angles(type, time);
  HingeFit fit{.rotation = fitted_orientation(shaped, positions, Eigen::Matrix3d::Identity()),
               .shape = relative_to_mean(
                   columns_of_beads(rest_positions(shaped, Vec3::Zero(), Eigen::Matrix3d::Identity()))),
               .turns = {}};
  const Eigen::Matrix3d H = fit.rotation.transpose() * relative_to_mean(positions) * fit.shape.transpose();
  // Where all beads are in line, a turn about the line is undetermined, and the smallest one is taken.
  const Eigen::Matrix3d identity = Eigen::Matrix3d::Identity();
  fit.turns = least_squares(H.trace() * identity - H, identity);
  return fit;
}

HingeStrain hinge_strain(const HingeFit& fit, const Angle& hinge, double rest, const BeadVectors& positions) {
  const auto [i, j, l] = hinge.beads;
  const AngleSides sides = sides_of(hinge, positions);
  const Bending bend = bending(sides);
  HingeStrain result{.strain = bend.vector, .derivative = {}};
  auto& B = result.derivative;
  B.setZero(3, 3 * positions.cols());
  const auto by_side = [&](const Eigen::Matrix3d& by_direction, int side) -> Eigen::Matrix3d {
    const Vec3& along = sides.direction[side];
    return (by_direction - by_direction * along * along.transpose()) / sides.length[side];
  };
  const Eigen::Matrix3d by_first = by_side(bend.by_first, 0), by_second = by_side(bend.by_second, 1);
  B.middleCols<3>(3 * i) = -by_first;
  B.middleCols<3>(3 * j) = by_first - by_second;
  B.middleCols<3>(3 * l) = by_second;
  if (rest == 0) return result;
  result.strain -= rest * (fit.rotation * *hinge.normal);
  const Eigen::Matrix3d by_turn = rest * fit.rotation * cross_matrix(*hinge.normal) * fit.turns;
  for (int b = 0; b < positions.cols(); ++b)
    B.middleCols<3>(3 * b) += by_turn * cross_matrix(fit.shape.col(b)) * fit.rotation.transpose();
  return result;
}

double angle_of(const SwimmerType& type, const Angle& angle, double time, const BeadVectors& positions) {
  const AngleSides sides = sides_of(angle, positions);
  if (!angle.normal) return std::atan2(sides.sine, sides.cosine);
  return bending(sides).vector.dot(fit_hinges(type, time, positions).rotation * *angle.normal);
}

double bending_of(const SwimmerType& type, std::size_t angle, double time, const BeadVectors& positions) {
  const Angle& spring = type.angles[angle];
  const double rest = rest_angle(type, angle, time);
  if (!spring.normal) return angle_of(type, spring, time, positions) - rest;
  return hinge_strain(fit_hinges(type, time, positions), spring, rest, positions).strain.norm();
}

double width_of(const BeadVectors& beads) {
  const Eigen::Matrix3Xd at = relative_to_mean(beads);
  return std::sqrt(std::max(SymmetricModes(at * at.transpose()).values[1], 0.0) / at.cols());
}

}  // namespace beadswim
