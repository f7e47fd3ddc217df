#pragma once

#include <Eigen/Core>
#include <array>

// clang-format off
// Matrix S (N x N) and number tau that correct an approximate mobility matrix M_r of N spheres on a line. If S
// maps the forces f on the spheres and S^T the velocities, M_r - tau 1 1^T gives the velocities of the exact
// mobility matrix M_x. Forces and velocities are along the line:
//
//   S^T (M_r - tau 1 1^T) S f = M_x f    for all forces f,    1^T S = 1^T
//
//   S   = B (A_r^-1 # A_x) B^T (I - n_x 1^T) + n_r 1^T,      A = B^T M B,      n = M^-1 1 / (1^T M^-1 1)
//   tau = 1/(1^T M_r^-1 1) - 1/(1^T M_x^-1 1)
//
//   B         orthonormal basis of the forces that sum to zero, N x (N - 1)
//   1         vector of N ones;  I  unit matrix
//   A_r, n_r  A and n for M = M_r;  A_x, n_x  A and n for M = M_x
//   n         forces of sum 1 under which all spheres have the same velocity
//   #         geometric mean of two positive definite matrices: G = A_r^-1 # A_x is the positive definite
//             solution of G A_r G = A_x
//
// S conserves the sum of the forces, so the leading term of the flow far from the spheres is unchanged. S^T
// leaves velocities unchanged if they are equal for all spheres. S is never singular, so S^T M_r S is
// positive definite if M_r is positive definite. Under the forces n_x, S^T M_r S gives all spheres one common
// velocity. This velocity is the one that M_r gives under the forces n_r; it exceeds the exact one by tau.
//
// Page: docs/method/near-field.md. Geometric mean: Bhatia, Positive Definite Matrices (Princeton 2007),
// chapter 4.
// clang-format on

namespace beadswim {

/// Matrix of the spheres on a line.
template <int N>
using LineMatrix = Eigen::Matrix<double, N, N>;

template <int N>
struct LineMap {
  LineMatrix<N> map;  ///< S
  double tow_defect;  ///< tau, in the unit of the mobility matrices
};

/// Returns S and tau for the mobility matrices M_x = `exact` and M_r = `approximate` of N = 2 or 3 spheres on
/// a line. Both must be symmetric, positive definite and in the same unit. Otherwise the result is undefined
/// and may be non-finite.
template <int N>
LineMap<N> line_map(const LineMatrix<N>& exact, const LineMatrix<N>& approximate);

/// Returns the matrix logarithm of the matrix S = `map` of two spheres (line_map). Each column of S - I sums
/// to zero, so S - I has rank one. Therefore log S = log(s)/(s - 1) (S - I) with s = 1 + trace(S - I).
LineMatrix<2> log_of_pair_map(const LineMatrix<2>& map);

// clang-format off
/// Returns the mobility matrix of N = 2 or 3 spheres on a line by induced stresslets (near_map.hpp) [time/mass]:
///
///   [I; -K]^T [M_FF, M_FH; M_HF, M_HH] [I; -K] = M_FF - K^T M_HF - M_FH K + K^T M_HH K
///
///   (M_HF)_ij = sqrt(2/3) (18 (a_i^2/10 + a_j^2/6)/r^2 - 3)/(8 pi eta r^2)   with the sign of x_i - x_j
///   (M_HH)_ij = (36/5 (a_i^2 + a_j^2)/r^2 - 6)/(8 pi eta r^3),               (M_HH)_ii = 3/(20 pi eta a_i^3)
///   K_ij      = w(2 r/(a_i + a_j)) (M_HF)_ij/(M_HH)_ii
///
///   M_FF  Rotne-Prager mobility
///   H     stresslet H sqrt(3/2) (ee - I/3) of a sphere, e along the line (force_moments.hpp)
///   r     distance of the centres of spheres i and j, a their radii [length]
///
/// Positions x along the line [length] must increase, and spheres must not overlap. `viscosity` eta is dynamic
/// [mass/(length time)].
// clang-format on
template <int N>
LineMatrix<N> strained_line(const std::array<double, N>& radii, const std::array<double, N>& positions,
                            double viscosity, double (*weight)(double));

}  // namespace beadswim
