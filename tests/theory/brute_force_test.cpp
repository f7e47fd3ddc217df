#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>
#include <numbers>

#include "swimmers.hpp"

// Tests the perturbation theory by integrating the equations of motion of the three beads in time. The
// mobility is written out in this file, and the driving amplitude tends to zero.

namespace beadswim {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr double pi = std::numbers::pi;

/// Returns the mobility by equations (4.15) to (4.17) of the paper in their correct form. `size`: 1 for
/// Rotne-Prager, 0 for Oseen.
Matrix3d mobility_of(const CollinearSwimmer& s, const Vector3d& x, double size) {
  Matrix3d m;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      const double r = std::abs(x[i] - x[j]);
      const double a2 = std::pow(s.radius[i], 2) + std::pow(s.radius[j], 2);
      m(i, j) = i == j ? 1 / s.radius[i] : 3 / (2 * r) - size * a2 / (2 * std::pow(r, 3));
    }
  }
  return m / (6 * pi * s.viscosity);
}

/// Returns the bead velocities: v = mu (F + springs + dashpots). Forces of dashpots are linear in v, so a
/// linear system is solved.
Vector3d velocity(const CollinearSwimmer& s, const Vector3d& x, double t, double size) {
  const double w = 2 * pi / s.period;
  const double f1 = s.amplitude[0] * std::sin(w * t), f3 = s.amplitude[1] * std::sin(w * t + s.phase);
  const double pull_1 = s.stiffness[0] * (x[1] - x[0] - s.arm[0]);
  const double pull_2 = s.stiffness[1] * (x[2] - x[1] - s.arm[1]);
  const Vector3d elastic(f1 + pull_1, -f1 - f3 - pull_1 + pull_2, f3 - pull_2);
  Matrix3d dashpots;  // force on the beads = -dashpots * v
  dashpots << s.damping[0], -s.damping[0], 0, -s.damping[0], s.damping[0] + s.damping[1], -s.damping[1], 0,
      -s.damping[1], s.damping[1];
  const Matrix3d mu = mobility_of(s, x, size);
  return (Matrix3d::Identity() + mu * dashpots).partialPivLu().solve(mu * elastic);
}

struct Cycle {
  double mean_velocity;
  Eigen::Vector2d mean_arms;
};

/// Returns means over the last of `periods` cycles, by the fourth-order Runge-Kutta method.
Cycle integrate(const CollinearSwimmer& s, double size, int periods, int steps) {
  const double h = s.period / steps;
  Vector3d x(-s.arm[0], 0, s.arm[1]), start = x;
  Eigen::Vector2d arm_sum(0, 0);
  for (int cycle = 0; cycle < periods; ++cycle) {
    start = x;
    arm_sum.setZero();
    for (int n = 0; n < steps; ++n) {
      arm_sum += Eigen::Vector2d(x[1] - x[0], x[2] - x[1]);  // rectangles: exact for a periodic function
      const double t = n * h;
      const Vector3d k1 = velocity(s, x, t, size);
      const Vector3d k2 = velocity(s, x + h / 2 * k1, t + h / 2, size);
      const Vector3d k3 = velocity(s, x + h / 2 * k2, t + h / 2, size);
      const Vector3d k4 = velocity(s, x + h * k3, t + h, size);
      x += h / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
    }
  }
  return {(x - start).mean() / s.period, arm_sum / steps};
}

struct SmallAmplitudeLimit {
  double velocity;              ///< V/A^2
  Eigen::Vector2d arm_changes;  ///< m/A^2
};

/// Returns V/A^2 and m/A^2 for A -> 0. The values are even in A, so two amplitudes suffice to cancel the
/// error of order A^2.
SmallAmplitudeLimit limit_of(CollinearSwimmer s, double size, double scale) {
  const Eigen::Vector2d rest(s.arm[0], s.arm[1]);
  const std::array<double, 2> unit = s.amplitude;
  const auto at = [&](double amplitude) {
    s.amplitude = {amplitude * unit[0], amplitude * unit[1]};
    const Cycle cycle = integrate(s, size, 30, 400);
    const double squared = amplitude * amplitude;
    return SmallAmplitudeLimit{cycle.mean_velocity / squared, (cycle.mean_arms - rest) / squared};
  };
  const SmallAmplitudeLimit full = at(scale), half = at(scale / 2);
  return {(4 * half.velocity - full.velocity) / 3, (4 * half.arm_changes - full.arm_changes) / 3};
}

void expect_equal_motion(const CollinearSwimmer& swimmer, PairLaw law, double size) {
  constexpr double truncation = 1e-6;  // relative: amplitude^4 after extrapolation, time step^4
  const SmallAmplitudeLimit integrated = limit_of(swimmer, size, 0.02);
  const PeriodicMotion expanded = second_order_motion(swimmer, rest_mobility(swimmer, law));
  EXPECT_NEAR(expanded.velocity / integrated.velocity, 1, truncation);
  EXPECT_NEAR(expanded.arm_changes[0] / integrated.arm_changes[0], 1, truncation);
  EXPECT_NEAR(expanded.arm_changes[1] / integrated.arm_changes[1], 1, truncation);
}

TEST(PerturbationAgainstIntegration, RotnePragerWithUnequalPartsAndDampers) {
  expect_equal_motion(unequal_swimmer(), rotne_prager, 1);
}

TEST(PerturbationAgainstIntegration, OseenWithUnequalPartsAndDampers) {
  expect_equal_motion(unequal_swimmer(), oseen, 0);
}

TEST(PerturbationAgainstIntegration, RotnePragerWithNearBeads) {
  CollinearSwimmer swimmer = unequal_swimmer();
  swimmer.arm = {9, 10};
  expect_equal_motion(swimmer, rotne_prager, 1);
}

TEST(PerturbationAgainstIntegration, RotnePragerOfThePapersSwimmer) {
  expect_equal_motion(paper_swimmer(4800), rotne_prager, 1);
}

}  // namespace
}  // namespace beadswim
