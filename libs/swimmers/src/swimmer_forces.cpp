#include "beadswim/swimmers/swimmer_forces.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <vector>

#include "beadswim/core/complex.hpp"
#include "beadswim/swimmers/hinges.hpp"

namespace beadswim {
namespace {

/// Returns theta - rest divided by sin(theta), where `sine` and `cosine` are those of the angle theta. A
/// swimmer with the rest angle 0 has the limit 1 at theta = 0.
double bending_over_sine(double sine, double cosine, double rest) {
  constexpr double smallest_sine = 1e-12;
  if (sine > smallest_sine) return (std::atan2(sine, cosine) - rest) / sine;
  if (rest == 0 && cosine > 0) return 1;
  return 0;
}

/// Returns the rotation of the directions of forces to the box.
Eigen::Matrix3d frame_of_forces(const SwimmerType& type, const BeadVectors& position,
                                const Eigen::Matrix3d& initial_orientation) {
  if (type.driving.frame == DrivingFrame::initial_axis) return initial_orientation;
  if (type.driving.frame == DrivingFrame::body)
    return fitted_orientation(type, position, initial_orientation);
  return Eigen::Matrix3d::Identity();
}

}  // namespace

double value_of(std::span<const Harmonic> harmonics, const Driving& driving, double time) {
  const double omega_t = 2 * std::numbers::pi * (time / driving.period) + driving.phase_offset;
  double sum = 0;
  for (const Harmonic& harmonic : harmonics)
    sum += harmonic.amplitude * std::sin(harmonic.multiple * omega_t + harmonic.phase);
  return sum;
}

double rate_of(std::span<const Harmonic> harmonics, const Driving& driving, double time) {
  const double omega = 2 * std::numbers::pi / driving.period;
  const double omega_t = omega * time + driving.phase_offset;
  double sum = 0;
  for (const auto& [amplitude, phase, multiple] : harmonics)
    sum += multiple * omega * amplitude * std::cos(multiple * omega_t + phase);
  return sum;
}

double sum_of_amplitudes(std::span<const Harmonic> harmonics) {
  double sum = 0;
  for (const Harmonic& harmonic : harmonics) sum += std::abs(harmonic.amplitude);
  return sum;
}

double rest_length(const SwimmerType& type, std::size_t bond, double time) {
  double length = type.bonds[bond].rest_length;
  for (const BondDrive& drive : type.driving.bonds) {
    if (drive.quantity == BondQuantity::rest_length && drive.bond == static_cast<int>(bond))
      length += value_of(drive.harmonics, type.driving, time);
  }
  return length;
}

double rest_angle(const SwimmerType& type, std::size_t angle, double time) {
  double rest = type.angles[angle].rest;
  for (const AngleDrive& drive : type.driving.angles) {
    if (drive.angle == static_cast<int>(angle)) rest += value_of(drive.harmonics, type.driving, time);
  }
  return rest;
}

BeadVectors bond_forces(const SwimmerType& type, double time, const BeadVectors& position,
                        const BeadVectors& velocity) {
  BeadVectors force = zero_vectors(type);
  for (std::size_t k = 0; k < type.bonds.size(); ++k) {
    const Bond& bond = type.bonds[k];
    const auto [i, j] = bond.beads;
    const Vec3 separation = position.col(j) - position.col(i);
    const double length = separation.norm();
    const Vec3 direction = separation / length;
    const double rate = direction.dot(velocity.col(j) - velocity.col(i));
    const double tension = bond.stiffness * (length - rest_length(type, k, time)) + bond.damping * rate;
    force.col(i) += tension * direction;
    force.col(j) -= tension * direction;
  }
  return force;
}

AngleSides sides_of(const Angle& angle, const BeadVectors& position) {
  AngleSides sides{};
  for (int s = 0; s < 2; ++s) {
    const Vec3 side = position.col(angle.beads[s + 1]) - position.col(angle.beads[s]);
    sides.length[s] = side.norm();
    sides.direction[s] = side / sides.length[s];
  }
  sides.cosine = sides.direction[0].dot(sides.direction[1]);
  sides.sine = sides.direction[0].cross(sides.direction[1]).norm();
  return sides;
}

BeadVectors angle_forces(const SwimmerType& type, double time, const BeadVectors& position) {
  BeadVectors force = zero_vectors(type);
  std::optional<HingeFit> fit;
  if (has_hinges(type)) fit = fit_hinges(type, time, position);
  for (std::size_t k = 0; k < type.angles.size(); ++k) {
    const Angle& angle = type.angles[k];
    if (angle.normal) {
      const auto [strain, derivative] = hinge_strain(*fit, angle, rest_angle(type, k, time), position);
      force.reshaped() -= angle.stiffness * derivative.transpose() * strain;
      continue;
    }
    const auto [i, j, l] = angle.beads;
    const auto [direction, length, cosine, sine] = sides_of(angle, position);
    // Gradients of the bending energy U = K_A (theta - rest)^2/2 with respect to the vectors of the sides.
    const double ratio = bending_over_sine(sine, cosine, rest_angle(type, k, time));
    const Vec3 gradient_1 = -angle.stiffness * ratio / length[0] * (direction[1] - cosine * direction[0]);
    const Vec3 gradient_2 = -angle.stiffness * ratio / length[1] * (direction[0] - cosine * direction[1]);
    force.col(i) += gradient_1;
    force.col(j) += gradient_2 - gradient_1;
    force.col(l) += -gradient_2;
  }
  return force;
}

std::map<int, double> net_forces(const Driving& driving) {
  std::map<int, std::pair<Eigen::Vector3cd, double>> sums;  // of the forces, and of their sizes
  for (const ForceDrive& drive : driving.forces) {
    const auto add = [&](int multiple, const Complex& amplitude) {
      auto& [sum, size] = sums.try_emplace(multiple, Eigen::Vector3cd::Zero(), 0.0).first->second;
      sum += amplitude * drive.direction.cast<Complex>();
      size += std::abs(amplitude);
    };
    add(0, drive.constant);
    for (const Harmonic& harmonic : drive.harmonics)
      add(harmonic.multiple, std::polar(1.0, harmonic.phase) * harmonic.amplitude);
  }
  constexpr double roundoff = 1e-9;
  std::map<int, double> net;
  for (const auto& [multiple, sum_and_size] : sums) {
    const auto& [sum, size] = sum_and_size;
    if (sum.norm() > roundoff * size) net[multiple] = sum.norm();
  }
  return net;
}

double largest_driving_force(const SwimmerType& type) {
  std::vector<double> force(type.beads.size());
  for (const ForceDrive& drive : type.driving.forces)
    force[drive.bead] += std::abs(drive.constant) + sum_of_amplitudes(drive.harmonics);
  for (const BondDrive& drive : type.driving.bonds) {
    const Bond& bond = type.bonds[drive.bond];
    const double per_amplitude = drive.quantity == BondQuantity::tension ? 1 : bond.stiffness;
    for (const int bead : bond.beads) force[bead] += per_amplitude * sum_of_amplitudes(drive.harmonics);
  }
  return *std::ranges::max_element(force);
}

BeadVectors driving_forces(const SwimmerType& type, double time, const BeadVectors& position,
                           const Eigen::Matrix3d& initial_orientation) {
  const Driving& driving = type.driving;
  BeadVectors force = zero_vectors(type);
  if (!driving.forces.empty()) {
    const Eigen::Matrix3d frame = frame_of_forces(type, position, initial_orientation);
    for (const ForceDrive& drive : driving.forces)
      force.col(drive.bead) +=
          (drive.constant + value_of(drive.harmonics, driving, time)) * (frame * drive.direction);
  }
  for (const BondDrive& drive : driving.bonds) {
    if (drive.quantity != BondQuantity::tension) continue;
    const auto [i, j] = type.bonds[drive.bond].beads;
    const Vec3 along =
        value_of(drive.harmonics, driving, time) * (position.col(j) - position.col(i)).normalized();
    force.col(i) += along;
    force.col(j) -= along;
  }
  return force;
}

double power_of_drives(const SwimmerType& type, double time, const BeadVectors& position,
                       const BeadVectors& velocity, const Eigen::Matrix3d& initial_orientation) {
  const Driving& driving = type.driving;
  double power = driving_forces(type, time, position, initial_orientation).cwiseProduct(velocity).sum();
  for (const BondDrive& drive : driving.bonds) {
    if (drive.quantity != BondQuantity::rest_length) continue;
    const Bond& bond = type.bonds[drive.bond];
    const double length = (position.col(bond.beads[1]) - position.col(bond.beads[0])).norm();
    power -= bond.stiffness * (length - rest_length(type, drive.bond, time)) *
             rate_of(drive.harmonics, driving, time);
  }
  for (const AngleDrive& drive : driving.angles) {
    const Angle& angle = type.angles[drive.angle];
    power -= angle.stiffness * (angle_of(type, angle, time, position) - rest_angle(type, drive.angle, time)) *
             rate_of(drive.harmonics, driving, time);
  }
  return power;
}

}  // namespace beadswim
