#include "beadswim/compare/driving_power.hpp"

#include <cmath>
#include <functional>
#include <numbers>

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

/// Returns the rate of change at time n of a period with M equidistant times, by the trigonometric polynomial
/// through the values at these times, multiplied by the period.
Vec3 rate_at(const std::vector<Vec3>& values, int n) {
  const int M = static_cast<int>(values.size());
  Vec3 rate = Vec3::Zero();
  for (int m = 0; m < M; ++m) {
    if (m == n) continue;
    const double half = std::numbers::pi * (n - m) / M, sign = (n - m) % 2 == 0 ? 1 : -1;
    rate += std::numbers::pi * sign * (M % 2 == 0 ? std::cos(half) : 1) / std::sin(half) * values[m];
  }
  return rate;
}

/// Returns the mean power of forces that turn with the swimmer: the mean over the samples of force times
/// velocity. Each velocity is that of the uniform motion over the cycle and of the periodic rest.
double power_of_turning_forces(SwimmerType type, const Eigen::Matrix3d& initial_orientation,
                               std::span<const SwimmerSample> samples) {
  type.driving.bonds.clear();
  const auto times = samples.size() - 1;
  const double interval = samples.back().time - samples.front().time;
  std::vector<BeadVectors> forces;
  for (const SwimmerSample& sample : samples.first(times)) {
    const BeadVectors beads = columns_of_beads(sample.bead_positions);
    forces.push_back(driving_forces(type, sample.time, beads, initial_orientation));
  }
  double power = 0;
  for (std::size_t bead = 0; bead < type.beads.size(); ++bead) {
    const Vec3 uniform = samples.back().bead_positions[bead] - samples.front().bead_positions[bead];
    std::vector<Vec3> rest;
    for (std::size_t n = 0; n < times; ++n)
      rest.push_back(samples[n].bead_positions[bead] -
                     static_cast<double>(n) / static_cast<double>(times) * uniform);
    for (std::size_t n = 0; n < times; ++n)
      power += Vec3(forces[n].col(bead)).dot(uniform + rate_at(rest, static_cast<int>(n)));
  }
  return power / (interval * static_cast<double>(times));
}

}  // namespace

std::optional<double> driving_power(const SwimmerType& type, const Eigen::Matrix3d& initial_orientation,
                                    std::span<const SwimmerSample> samples) {
  const Driving& driving = type.driving;
  if (!are_resolved(driving, std::ssize(samples) - 1)) return std::nullopt;
  const SwimmerSample &first = samples.front(), &last = samples.back();
  const bool turns = driving.frame == DrivingFrame::body && !driving.forces.empty();
  double power = turns ? power_of_turning_forces(type, initial_orientation, samples) : 0;
  for (const ForceDrive& drive : turns ? std::vector<ForceDrive>{} : driving.forces) {
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
               return angle_between(angle, sample.bead_positions);
             });
  }
  return power;
}

}  // namespace beadswim
