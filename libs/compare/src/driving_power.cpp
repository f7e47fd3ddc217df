#include "beadswim/compare/driving_power.hpp"

#include <cmath>
#include <functional>
#include <numbers>

#include "beadswim/core/trigonometric_nodes.hpp"
#include "beadswim/swimmers/hinges.hpp"
#include "beadswim/swimmers/swimmer_forces.hpp"
#include "beadswim/swimmers/swimmer_shape.hpp"

namespace beadswim {
namespace {

/// Coordinate of a swimmer that a drive acts on.
using Coordinate = std::function<double(const SwimmerSample&)>;

/// Returns the sum of -n w/2 A d cos(delta - psi) over the harmonics of a drive.
double power_of(const std::vector<Harmonic>& harmonics, const Driving& driving,
                std::span<const SwimmerSample> samples, const Coordinate& coordinate) {
  double power = 0;
  for (const Harmonic& harmonic : harmonics) {
    const double omega = 2 * std::numbers::pi * harmonic.multiple / driving.period;
    const double psi = harmonic.multiple * driving.phase_offset + harmonic.phase;
    const StrokeFit fit = fit_cycle(samples, driving.period / harmonic.multiple, coordinate);
    power -= omega / 2 * harmonic.amplitude * fit.amplitude * std::cos(fit.phase - psi);
  }
  return power;
}

/// Returns true if this number of samples per period resolves all harmonics of the drives.
bool are_resolved(const Driving& driving, std::ptrdiff_t samples) {
  bool all = true;
  for_each_harmonic(driving, [&](const Harmonic& harmonic) { all &= 2 * harmonic.multiple < samples; });
  return all;
}

/// Returns the mean power of forces that turn with the swimmer: the mean over the samples of force times
/// velocity. Each velocity is that of the uniform motion over the cycle and of the periodic rest.
double power_of_turning_forces(SwimmerType type, const Eigen::Matrix3d& initial_orientation,
                               std::span<const SwimmerSample> samples) {
  if (type.driving.forces.empty()) return 0;
  type.driving.bonds.clear();
  const auto times = static_cast<int>(samples.size()) - 1;
  const SwimmerSample &first = samples.front(), &last = samples.back();
  const BeadVectors moved = columns_of_beads(last.bead_positions) - columns_of_beads(first.bead_positions);
  // Rows: forces on the beads, and positions without the uniform motion, at one time.
  Eigen::MatrixXd forces(times, moved.size()), rest(times, moved.size());
  for (int n = 0; n < times; ++n) {
    const BeadVectors beads = columns_of_beads(samples[n].bead_positions);
    forces.row(n) = driving_forces(type, samples[n].time, beads, initial_orientation).reshaped();
    rest.row(n) = (beads - static_cast<double>(n) / times * moved).reshaped();
  }
  const Eigen::MatrixXd velocities = (2 * std::numbers::pi * differentiation_matrix(times) * rest).rowwise() +
                                     moved.reshaped().transpose();  // multiplied by the interval
  return forces.cwiseProduct(velocities).sum() / (times * (last.time - first.time));
}

/// Returns the mean power of forces along directions that are fixed in the box.
double power_of_fixed_forces(const Driving& driving, const Eigen::Matrix3d& initial_orientation,
                             std::span<const SwimmerSample> samples) {
  const SwimmerSample &first = samples.front(), &last = samples.back();
  double power = 0;
  for (const ForceDrive& drive : driving.forces) {
    const Vec3 direction =
        driving.frame == DrivingFrame::lab ? drive.direction : Vec3(initial_orientation * drive.direction);
    const Vec3 velocity =
        (last.bead_positions[drive.bead] - first.bead_positions[drive.bead]) / (last.time - first.time);
    const auto periodic_part = [&](const SwimmerSample& sample) {
      return direction.dot(sample.bead_positions[drive.bead] - velocity * (sample.time - first.time));
    };
    power +=
        drive.constant * direction.dot(velocity) + power_of(drive.harmonics, driving, samples, periodic_part);
  }
  return power;
}

}  // namespace

std::optional<double> driving_power(const SwimmerType& type, const Eigen::Matrix3d& initial_orientation,
                                    std::span<const SwimmerSample> samples) {
  const Driving& driving = type.driving;
  if (!are_resolved(driving, std::ssize(samples) - 1)) return std::nullopt;
  double power = driving.frame == DrivingFrame::body
                     ? power_of_turning_forces(type, initial_orientation, samples)
                     : power_of_fixed_forces(driving, initial_orientation, samples);
  for (const BondDrive& drive : driving.bonds) {
    const Bond& bond = type.bonds[drive.bond];
    const double on_length = power_of(drive.harmonics, driving, samples, [&](const SwimmerSample& sample) {
      return bond_vector(sample, bond).norm();
    });
    power += drive.quantity == BondQuantity::tension ? -on_length : bond.stiffness * on_length;
  }
  for (const AngleDrive& drive : driving.angles) {
    const Angle& angle = type.angles[drive.angle];
    power += angle.stiffness * power_of(drive.harmonics, driving, samples, [&](const SwimmerSample& sample) {
               return angle_of(type, angle, sample.time, columns_of_beads(sample.bead_positions));
             });
  }
  return power;
}

}  // namespace beadswim
