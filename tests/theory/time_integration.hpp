#pragma once

#include <Eigen/Core>
#include <Eigen/LU>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "beadswim/theory/collinear_swimmer.hpp"

// Motion of a swimmer by integration in time, and its periodic motion by the shooting method.
//
// The equations of motion of the beads are integrated by Bulirsch and Stoer's extrapolation of the modified
// midpoint rule, to order 16. Newton's method finds the arm lengths that a period reproduces. The mobility is
// given as a function of the arm lengths; its derivatives are not needed.

namespace beadswim::timestepping {

using Real = long double;
using Vector3 = Eigen::Matrix<Real, 3, 1>;
using Vector2 = Eigen::Matrix<Real, 2, 1>;
using Matrix3 = Eigen::Matrix<Real, 3, 3>;
using Matrix2 = Eigen::Matrix<Real, 2, 2>;

/// Returns the bead velocities: v = mu (F + springs + dashpots). Forces of dashpots are linear in v, so a
/// linear system is solved.
template <class Mobility>
Vector3 velocity(const CollinearSwimmer& s, const Mobility& mobility, const Vector3& x, Real t) {
  const Real w = 2 * std::numbers::pi_v<Real> / s.period;
  const Real f1 = s.amplitude[0] * std::sin(w * t), f3 = s.amplitude[1] * std::sin(w * t + s.phase);
  const Real pull_1 = s.stiffness[0] * (x[1] - x[0] - s.arm[0]);
  const Real pull_2 = s.stiffness[1] * (x[2] - x[1] - s.arm[1]);
  const Real c1 = s.damping[0], c2 = s.damping[1];
  const Vector3 elastic(f1 + pull_1, -f1 - f3 - pull_1 + pull_2, f3 - pull_2);
  Matrix3 dashpots;  // force on the beads = -dashpots * v
  dashpots << c1, -c1, 0, -c1, c1 + c2, -c2, 0, -c2, c2;
  const Matrix3 mu = mobility(x[1] - x[0], x[2] - x[1]);
  const Matrix3 system = Matrix3::Identity() + mu * dashpots;
  return system.partialPivLu().solve(Vector3(mu * elastic));
}

/// Performs one large step by the modified midpoint rule with 2, 4, ..., 16 substeps, extrapolated to
/// substeps of length zero.
template <class Mobility>
Vector3 extrapolated_step(const CollinearSwimmer& s, const Mobility& mobility, const Vector3& x, Real t,
                          Real step) {
  constexpr int columns = 8;
  std::array<Vector3, columns> table;
  for (int row = 0; row < columns; ++row) {
    const int parts = 2 * (row + 1);
    const Real h = step / parts;
    Vector3 before = x, now = x + h * velocity(s, mobility, x, t);
    for (int n = 1; n < parts; ++n) {
      const Vector3 after = before + 2 * h * velocity(s, mobility, now, t + n * h);
      before = now;
      now = after;
    }
    table[row] = now;
    for (int column = row - 1; column >= 0; --column) {
      const Real ratio = Real(parts) / (2 * (column + 1));
      table[column] = table[column + 1] + (table[column + 1] - table[column]) / (ratio * ratio - 1);
    }
  }
  return table[0];
}

/// Displacement of bead 2, final arm lengths, mean arm lengths and mean power of the driving in a period that
/// begins with given arm lengths.
struct Period {
  Real displacement;
  Vector2 arms, arm_means;
  Real power;
};

template <class Mobility>
Period integrate(const CollinearSwimmer& s, const Mobility& mobility, const Vector2& arms, int steps) {
  const Real h = Real(s.period) / steps;
  Vector3 x(-arms[0], 0, arms[1]);
  Vector2 sum(0, 0);
  Real work_rate = 0;
  for (int n = 0; n < steps; ++n) {
    const Real phase = 2 * std::numbers::pi_v<Real> * n / steps;
    const Real f1 = s.amplitude[0] * std::sin(phase), f3 = s.amplitude[1] * std::sin(phase + s.phase);
    work_rate += Vector3(f1, -f1 - f3, f3).dot(velocity(s, mobility, x, n * h));
    sum += Vector2(x[1] - x[0], x[2] - x[1]);  // rectangles: exact for a periodic function
    x = extrapolated_step(s, mobility, x, n * h, h);
  }
  return {x[1], Vector2(x[1] - x[0], x[2] - x[1]), sum / steps, work_rate / steps};
}

struct Motion {
  double velocity;
  std::array<double, 2> arm_means;
  double power;
};

/// Returns the periodic motion. `arms`: initial guess of the arm lengths at t = 0.
template <class Mobility>
Motion periodic(const CollinearSwimmer& s, const Mobility& mobility, Vector2 arms, int steps) {
  for (int iteration = 0; iteration < 30; ++iteration) {
    const Period period = integrate(s, mobility, arms, steps);
    const Vector2 miss = period.arms - arms;
    Matrix2 jacobian;
    for (int arm = 0; arm < 2; ++arm) {
      Vector2 shifted = arms;
      const Real shift = 1e-7L * s.arm[arm];
      shifted[arm] += shift;
      jacobian.col(arm) = (integrate(s, mobility, shifted, steps).arms - shifted - miss) / shift;
    }
    const Vector2 change = jacobian.partialPivLu().solve(miss);
    arms -= change;
    if (change.norm() < 1e-13L * arms.norm()) {
      const Period last = integrate(s, mobility, arms, steps);
      return {static_cast<double>(last.displacement / s.period),
              {static_cast<double>(last.arm_means[0]), static_cast<double>(last.arm_means[1])},
              static_cast<double>(last.power)};
    }
  }
  throw std::runtime_error("no periodic motion");
}

}  // namespace beadswim::timestepping
