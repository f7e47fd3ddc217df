#pragma once

#include <Eigen/Core>
#include <cmath>
#include <complex>
#include <numbers>

// clang-format off
// Flow around one sphere with a force along x, in cylindrical coordinates (x, s) about its centre. s is the distance from the axis.
//
//   oscillating   u = (f/eta) [ W H e_x + grad d/dx Psi ]     outside,     u = f e_x / (6 pi eta a D)   inside
//   steady        u = (h/eta) [ phi e_x + grad d/dx B ]       outside,     u = h e_x / (6 pi eta a)     inside
//
//   phi = 1/(4 pi r),   H = e^{-alpha r} phi,   W = e^kappa / D,   kappa = alpha a,   D = 1 + kappa + kappa^2/3
//   Psi = (phi - W H)/alpha^2,   B = -r/(8 pi) - a^2/(24 pi r)
//
//   a, r      radius, distance from the centre [length];  alpha^2 = i omega rho/eta [1/length^2]
//   f, h      force on the fluid [mass length/time^2];  eta dynamic viscosity [mass/(length time)];  u flow [length/time]
//
// For a function q(r) with q_n = ((1/r) d/dr)^n q:   grad d/dx q = (q_1 + x^2 q_2) e_x + x s q_2 e_s
// clang-format on
//
// Both flows are divergence-free, and uniform on the surface of the sphere. Reference: Landau and Lifshitz,
// Fluid Mechanics, sections 20 and 24. Page: docs/method/inertia.md.

namespace beadswim {

/// Returns the flow per unit force of a sphere that oscillates with exp(i omega t) at the position (x, s)
/// relative to its centre, x along the force, s across: components along x and s [time/mass]. `viscosity` is
/// dynamic, alpha = sqrt(i omega rho/eta) with Re alpha > 0 [1/length].
inline Eigen::RowVector2cd oscillating_sphere_flow(double radius, double viscosity,
                                                   std::complex<double> alpha, double x, double s) {
  using std::numbers::pi;
  const double r = std::hypot(x, s);
  const std::complex<double> kappa = alpha * radius, D = 1.0 + kappa + kappa * kappa / 3.0;
  if (r <= radius) return {1.0 / (6 * pi * viscosity * radius * D), 0.0};
  const double phi = 1 / (4 * pi * r), r2 = r * r;
  const std::complex<double> ar = alpha * r, WH = std::exp(alpha * (radius - r)) / D * phi;
  // clang-format off
  const std::complex<double> Psi_1 = (   -phi + WH * (1.0 +       ar          )) / (     r2 * alpha * alpha);
  const std::complex<double> Psi_2 = (3 * phi - WH * (3.0 + 3.0 * ar + ar * ar)) / (r2 * r2 * alpha * alpha);
  // clang-format on
  return {(WH + Psi_1 + x * x * Psi_2) / viscosity, x * s * Psi_2 / viscosity};
}

/// Returns the gradient of the steady flow per unit force of a towed sphere at the position (x, s) relative
/// to its centre [time/(mass length)]. Rows: direction of the derivative. Columns: component of the flow.
inline Eigen::Matrix2d towed_sphere_gradient(double radius, double viscosity, double x, double s) {
  using std::numbers::pi;
  const double r2 = x * x + s * s, a2 = radius * radius;
  if (r2 <= a2) return Eigen::Matrix2d::Zero();
  const double r = std::sqrt(r2), phi_1 = -1 / (4 * pi * r2 * r);
  // clang-format off
  const double B_2 = ( 1 / (r2 * r)      -     a2 / (r2 * r2 * r))      / (8 * pi);
  const double B_3 = (-3 / (r2 * r2 * r) + 5 * a2 / (r2 * r2 * r2 * r)) / (8 * pi);
  const double mixed = s * B_2 + x * x * s * B_3;
  Eigen::Matrix2d gradient;
  gradient << x * phi_1 + 3 * x * B_2 + x * x * x * B_3,   mixed,
              s * phi_1 + mixed,                           x * B_2 + x * s * s * B_3;
  // clang-format on
  return gradient / viscosity;
}

}  // namespace beadswim
