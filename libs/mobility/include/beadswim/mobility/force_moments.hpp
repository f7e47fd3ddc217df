#pragma once

#include <Eigen/Core>
#include <array>

#include "beadswim/mobility/derivative_table.hpp"

// clang-format off
// Moments of the force that a sphere exerts on the fluid at its surface, up to the second. Fluid fills the
// insides of spheres too. The force per area on a sphere of radius a, with the normal n, is
//
//   f(n) = [ F + 3/a S n + Q : (nn - I/3) ] / (4 pi a^2)
//
//   F  force;  S  stresslet, symmetric and traceless
//   Q  second moment Q_abc, symmetric and traceless in b, c
//
// Its Fourier transform, with the spherical Bessel functions j_l, and the same as derivatives of a point force:
//
//   F j_0(ka) - i S k 3 j_1(ka)/(ka) - Q : kk/k^2 j_2(ka)
//   = P_0 F - P_1 S grad + (a^2/15) P_2 Q : grad grad,   P_l = 1 + c_l a^2 laplacian + ...,   c = 1/6, 1/10, 1/14
//
// The flow u of all forces is projected on the same functions:
//
//   velocity U = P_0 u,   rate of strain E: symmetric traceless part of P_1 grad u,
//   second moment of the velocity: (a^2/15) P_2 [grad grad u], traceless in the derivatives
//
// If spheres do not overlap, the further terms of P_l have no effect. Moments are stored as coefficients in an
// orthonormal basis: 3 of F, then 5 of S, then 15 of Q (5 for each component a of Q_abc). The basis of symmetric
// traceless tensors is xx - yy, 2 zz - xx - yy, xy, xz, yz, each normalised. In this basis the matrix from moments
// to projections is symmetric and positive definite.
//
// Mazur & van Saarloos, Physica A 115 (1982) 21. Page: docs/method/force-moments.md.
// clang-format on

namespace beadswim {

constexpr int max_moment_order = 2;

/// Returns the number of coefficients of the moments of a sphere up to `order`: 3, 8 or 23.
constexpr int moment_count(int order) {
  return std::array{3, 8, 23}[order];
}

/// Returns the degree of moment m of a sphere.
constexpr int degree_of_moment(int m) {
  return m < 3 ? 0 : (m < 8 ? 1 : 2);
}

/// Returns the stresslet S with these 5 coefficients.
Eigen::Matrix3d stresslet_of(const double* coefficients);

/// c_l of the equation above.
constexpr std::array<double, 3> size_factors{1.0 / 6, 1.0 / 10, 1.0 / 14};

/// Returns c_l a^2 of a sphere, by degree l.
constexpr std::array<double, 3> moment_sizes(double radius) {
  return {size_factors[0] * radius * radius, size_factors[1] * radius * radius,
          size_factors[2] * radius * radius};
}

// A source contains the coefficients of the derivatives of a point force, a flow the derivatives of a
// velocity, up to the order of the moments. Element c * derivative_count(order) + d is component c,
// derivative d (derivative_table.hpp).

/// Converts moments of a sphere to a source, without the factors P_l.
void source_of_moments(int order, double radius, const double* moments, double* source);

/// Projects a flow, to which the factors P_l have been applied, on the moments of a sphere.
void project_flow(int order, double radius, const double* flow, double* projections);

/// Returns the matrix from the moments of a sphere to the projections of its own flow in open space, as
/// blocks of moments of equal degree: F gives 1/(6 pi eta a), S gives 3/(20 pi eta a^3).
Eigen::MatrixXd moment_self_mobility(int order, double radius, double viscosity);

/// Returns the part of moment_self_mobility() by wavenumbers below `wavenumber`. In it, F and Q couple.
Eigen::MatrixXd moment_self_mobility_below(double wavenumber, int order, double radius, double viscosity);

/// Returns the part of moment_self_mobility() by the far part of an Ewald sum: by the wavenumbers k with the
/// weight s(k), and with P_l P_m = 1 + (c_l + c_m) a^2 laplacian, the terms that the flow of other spheres
/// needs. far_integrals: of k^(2 n) s(k), n = 0 to 3 [1/length^(2 n + 1)].
Eigen::MatrixXd far_moment_self_mobility(const std::array<double, 4>& far_integrals, int order, double radius,
                                         double viscosity);

}  // namespace beadswim
