#include "beadswim/swimmers/swimmer_dynamics.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "beadswim/core/error.hpp"

namespace beadswim {
namespace {

struct Phase {
  BeadVectors position, velocity;
};

/// Returns d(position, velocity)/dt.
Phase rate_of_change(const Phase& phase, const SwimmerType& type, const Vec3& initial_axis,
                     const SwimmerLoads& loads, double time) {
  const BeadVectors spring = spring_forces(type.springs, phase.position, phase.velocity);
  const BeadVectors angular = angular_spring_forces(type.angular_stiffness, phase.position);
  const BeadVectors driving = driving_forces(type.driving, time, phase.position, initial_axis);
  Phase rate;
  for (int b = 0; b < 3; ++b) {
    rate.position[b] = phase.velocity[b];
    rate.velocity[b] = (spring[b] + angular[b] + driving[b] + loads[b].force) / mass(type.beads[b]);
  }
  return rate;
}

Phase moved(const Phase& phase, const Phase& rate, double interval) {
  Phase result;
  for (int b = 0; b < 3; ++b) {
    result.position[b] = phase.position[b] + interval * rate.position[b];
    result.velocity[b] = phase.velocity[b] + interval * rate.velocity[b];
  }
  return result;
}

/// Returns omega^2/K_A = sum_i g_i^2/m_i, where omega is the angular frequency of bending, K_A the angular
/// stiffness and m_i the mass of bead i. The bending angle is theta = sum_i g_i y_i, with g = (1/l1, -1/l1 -
/// 1/l2, 1/l2), the rest lengths l1 and l2 of the arms, and the displacements y_i perpendicular to the
/// swimmer.
double bending_mobility(const SwimmerType& type) {
  const double g1 = 1 / type.springs[0].rest_length, g3 = 1 / type.springs[1].rest_length, g2 = g1 + g3;
  return g1 * g1 / mass(type.beads[0]) + g2 * g2 / mass(type.beads[1]) + g3 * g3 / mass(type.beads[2]);
}

}  // namespace

double mass(const Bead& bead) {
  return 4.0 / 3 * std::numbers::pi * std::pow(bead.radius, 3) * bead.density;
}

double moment_of_inertia(const Bead& bead) {
  return 2.0 / 5 * mass(bead) * bead.radius * bead.radius;
}

int substeps_for(const SwimmerType& type, double step) {
  const auto& [first, second] = type.springs;
  const std::array m{mass(type.beads[0]), mass(type.beads[1]), mass(type.beads[2])};
  // Gershgorin bound of the eigenvalues of (mass matrix)^-1 times (spring matrix) for stretching. a and b are
  // the stiffness or damping of the two springs.
  const auto stretching = [&m](double a, double b) {
    return std::max({2 * a / m[0], 2 * (a + b) / m[1], 2 * b / m[2]});
  };
  const double bending = type.angular_stiffness * bending_mobility(type);
  const double frequency = std::sqrt(std::max(stretching(first.stiffness, second.stiffness), bending));
  const double damping_rate = stretching(first.damping, second.damping);
  const double substeps = std::ceil(4 * step * std::max(frequency, damping_rate));
  constexpr double max_substeps = 10000;
  if (!(substeps <= max_substeps)) {
    throw InputError(
        "springs",
        fmt::format("the springs are so stiff or damped that a time step needs {:.3g} sub-steps, more than "
                    "the limit of {}; use softer springs, less damping or a smaller time step",
                    substeps, max_substeps));
  }
  return std::max(1, static_cast<int>(substeps));
}

SwimmerType with_resolved_vibrations(SwimmerType type, double step) {
  for (int arm = 0; arm < 2; ++arm) {
    Spring& spring = type.springs[arm];
    const double reduced_mass = 1 / (1 / mass(type.beads[arm]) + 1 / mass(type.beads[arm + 1]));
    const double omega = std::sqrt(spring.stiffness / reduced_mass);
    if (std::sqrt(1.5) * omega * step <= 0.5) continue;
    const double needed = std::min(0.5 * step * spring.stiffness, reduced_mass * omega);
    spring.damping = std::max(spring.damping, needed);
  }
  constexpr double fastest_bending = 0.75;  // largest angular frequency of bending [rad/step]
  const double stiffest = std::pow(fastest_bending / step, 2) / bending_mobility(type);
  type.angular_stiffness = std::min(type.angular_stiffness, stiffest);
  return type;
}

void advance_swimmer(SwimmerMotion& motion, const SwimmerType& type, const Vec3& initial_axis,
                     const SwimmerLoads& loads, double time, double step, int substeps) {
  Phase phase;
  for (int b = 0; b < 3; ++b) {
    phase.position[b] = motion[b].position;
    phase.velocity[b] = motion[b].velocity;
  }
  const double h = step / substeps;
  for (int n = 0; n < substeps; ++n) {
    const double t = time + n * h;
    const auto rate = [&](const Phase& at, double when) {
      return rate_of_change(at, type, initial_axis, loads, when);
    };
    const Phase k1 = rate(phase, t);
    const Phase k2 = rate(moved(phase, k1, h / 2), t + h / 2);
    const Phase k3 = rate(moved(phase, k2, h / 2), t + h / 2);
    const Phase k4 = rate(moved(phase, k3, h), t + h);
    phase = moved(moved(moved(moved(phase, k1, h / 6), k2, h / 3), k3, h / 3), k4, h / 6);
  }
  for (int b = 0; b < 3; ++b) {
    motion[b].position = phase.position[b];
    motion[b].velocity = phase.velocity[b];
    motion[b].angular_velocity += step / moment_of_inertia(type.beads[b]) * loads[b].torque;
  }
}

}  // namespace beadswim
