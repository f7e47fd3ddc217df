#include "beadswim/swimmers/swimmer_dynamics.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "beadswim/core/error.hpp"

namespace beadswim {
namespace {

struct Phase {
  BeadVectors position, velocity;
};

/// Returns d(position, velocity)/dt.
Phase rate_of_change(const Phase& phase, const SwimmerType& type, const Eigen::Matrix3d& initial_orientation,
                     std::span<const Load> loads, double time) {
  const BeadVectors bonds = bond_forces(type, time, phase.position, phase.velocity);
  const BeadVectors angles = angle_forces(type, time, phase.position);
  const BeadVectors driving = driving_forces(type, time, phase.position, initial_orientation);
  Phase rate{.position = phase.velocity, .velocity = bonds + angles + driving};
  for (std::size_t b = 0; b < type.beads.size(); ++b) {
    auto acceleration = rate.velocity.col(b);
    acceleration = (acceleration + loads[b].force) / mass(type.beads[b]);
  }
  return rate;
}

Phase moved(const Phase& phase, const Phase& rate, double interval) {
  return {.position = phase.position + interval * rate.position,
          .velocity = phase.velocity + interval * rate.velocity};
}

/// Returns an upper bound of omega^2/K_A = sum_i |g_i|^2/m_i of an angle alone, where omega is the angular
/// frequency of bending, K_A the angular stiffness and m_i the mass of bead i. g_i is the gradient of the
/// angle by the position of bead i, with |g| = 1/l1, at most 1/l1 + 1/l2, and 1/l2 for the lengths l1 and l2
/// of its sides at rest; the bound is exact for three beads in line.
double bending_mobility(const SwimmerType& type, const Angle& angle) {
  const auto [i, j, l] = angle.beads;
  const double g1 = 1 / distance_at_rest(type, i, j), g3 = 1 / distance_at_rest(type, j, l), g2 = g1 + g3;
  return g1 * g1 / mass(type.beads[i]) + g2 * g2 / mass(type.beads[j]) + g3 * g3 / mass(type.beads[l]);
}

/// Returns an upper bound of omega^2 if all angles of the type bend together. weight(angle): the contribution
/// K_A sum_i g_i^2/m_i of one angle alone. Gershgorin's theorem for the matrix of products of the gradients,
/// which vanish for angles without a common bead.
double bending_together(const SwimmerType& type, const std::size_t k, auto&& weight) {
  double sum = weight(type.angles[k]);
  for (std::size_t other = 0; other < type.angles.size(); ++other) {
    const bool touch = std::ranges::find_first_of(type.angles[k].beads, type.angles[other].beads) !=
                       type.angles[k].beads.end();
    if (other != k && touch) sum += std::sqrt(weight(type.angles[k]) * weight(type.angles[other]));
  }
  return sum;
}

}  // namespace

double mass(const Bead& bead) {
  return 4.0 / 3 * std::numbers::pi * std::pow(bead.radius, 3) * bead.density;
}

double moment_of_inertia(const Bead& bead) {
  return 2.0 / 5 * mass(bead) * bead.radius * bead.radius;
}

int substeps_for(const SwimmerType& type, double step) {
  // Gershgorin bound of the eigenvalues of (mass matrix)^-1 times (spring matrix) for stretching, with the
  // stiffness or the damping of the bonds.
  const auto stretching = [&type](double Spring::*strength) {
    std::vector<double> sum(type.beads.size());
    for (const Bond& bond : type.bonds)
      for (const int bead : bond.beads) sum[bead] += bond.*strength;
    double largest = 0;
    for (std::size_t b = 0; b < sum.size(); ++b)
      largest = std::max(largest, 2 * sum[b] / mass(type.beads[b]));
    return largest;
  };
  const double squared_stretching = stretching(&Spring::stiffness);
  double squared_bending = 0;
  for (std::size_t k = 0; k < type.angles.size(); ++k)
    squared_bending = std::max(squared_bending, bending_together(type, k, [&](const Angle& angle) {
                                 return angle.stiffness * bending_mobility(type, angle);
                               }));
  // In a straight swimmer, stretching and bending are independent.
  const double frequency = std::sqrt(is_straight(type) ? std::max(squared_stretching, squared_bending)
                                                       : squared_stretching + squared_bending);
  const double damping_rate = stretching(&Spring::damping);
  const double substeps = std::ceil(4 * step * std::max(frequency, damping_rate));
  constexpr double max_substeps = 10000;
  if (!(substeps <= max_substeps)) {
    throw InputError("springs",
                     "the springs are so stiff or damped that a time step needs {:.3g} sub-steps, more than "
                     "the limit of {}; use softer springs, less damping or a smaller time step",
                     substeps, max_substeps);
  }
  return std::max(1, static_cast<int>(substeps));
}

SwimmerType with_resolved_vibrations(SwimmerType type, double step) {
  std::vector<int> bonds(type.beads.size());  // number of bonds of each bead
  for (const Bond& bond : type.bonds)
    for (const int bead : bond.beads) ++bonds[bead];
  for (Bond& bond : type.bonds) {
    const auto [i, j] = bond.beads;
    const double reduced_mass = 1 / (1 / mass(type.beads[i]) + 1 / mass(type.beads[j]));
    const double omega = std::sqrt(bond.stiffness / reduced_mass);
    if (std::sqrt(0.5 * (bonds[i] + bonds[j])) * omega * step <= 0.5) continue;
    const double needed = std::min(0.5 * step * bond.stiffness, reduced_mass * omega);
    bond.damping = std::max(bond.damping, needed);
  }
  constexpr double fastest_bending = 0.75;  // largest angular frequency of bending [rad/step]
  for (std::size_t k = 0; k < type.angles.size(); ++k) {
    const double mobility =
        bending_together(type, k, [&](const Angle& angle) { return bending_mobility(type, angle); });
    const double stiffest = std::pow(fastest_bending / step, 2) / mobility;
    type.angles[k].stiffness = std::min(type.angles[k].stiffness, stiffest);
  }
  return type;
}

void advance_swimmer(std::span<BeadMotion> motion, const SwimmerType& type,
                     const Eigen::Matrix3d& initial_orientation, std::span<const Load> loads, double time,
                     double step, int substeps) {
  const auto beads = std::ssize(motion);
  Phase phase{.position = BeadVectors(3, beads), .velocity = BeadVectors(3, beads)};
  for (int b = 0; b < beads; ++b) {
    phase.position.col(b) = motion[b].position;
    phase.velocity.col(b) = motion[b].velocity;
  }
  const double h = step / substeps;
  for (int n = 0; n < substeps; ++n) {
    const double t = time + n * h;
    const auto rate = [&](const Phase& at, double when) {
      return rate_of_change(at, type, initial_orientation, loads, when);
    };
    const Phase k1 = rate(phase, t);
    const Phase k2 = rate(moved(phase, k1, h / 2), t + h / 2);
    const Phase k3 = rate(moved(phase, k2, h / 2), t + h / 2);
    const Phase k4 = rate(moved(phase, k3, h), t + h);
    phase = moved(moved(moved(moved(phase, k1, h / 6), k2, h / 3), k3, h / 3), k4, h / 6);
  }
  for (int b = 0; b < beads; ++b) {
    motion[b].position = phase.position.col(b);
    motion[b].velocity = phase.velocity.col(b);
    motion[b].angular_velocity += step / moment_of_inertia(type.beads[b]) * loads[b].torque;
  }
}

}  // namespace beadswim
