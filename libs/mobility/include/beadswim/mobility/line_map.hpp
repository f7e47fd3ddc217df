#pragma once

#include <Eigen/Core>
#include <span>

// clang-format off
// Matrix S (N x N) that corrects an approximate mobility matrix M_r of N spheres on a line. If S maps the
// forces f on the spheres and S^T the resulting velocities, M_r gives the velocities of the exact mobility
// matrix M_x. Forces and velocities are along the line:
//
//   S^T M_r S f = M_x f    for all forces f that sum to zero,    1^T S = 1^T
//
//   S = B (A_r^-1 # A_x) B^T (I - n_x 1^T) + n_r 1^T,      A = B^T M B,      n = M^-1 1 / (1^T M^-1 1)
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
// velocity. This velocity is the one that M_r gives under the forces n_r.
//
// Page: docs/method/near-field.md. Geometric mean: Bhatia, Positive Definite Matrices (Princeton 2007),
// chapter 4.
// clang-format on

namespace beadswim {

/// Returns the matrix S with S^T M_r S f = M_x f for all forces f on N spheres on a line that sum to zero,
/// where M_x = `exact` and M_r = `approximate` are mobility matrices. Both must be N x N, symmetric, positive
/// definite and in the same unit. Otherwise the result is undefined and may be non-finite.
Eigen::MatrixXd line_map(const Eigen::MatrixXd& exact, const Eigen::MatrixXd& approximate);

/// Returns the matrix logarithm of the matrix S = `map` of two spheres (line_map). Each column of S - I sums
/// to zero, so S - I has rank one. Therefore log S = log(s)/(s - 1) (S - I) with s = 1 + trace(S - I).
Eigen::Matrix2d log_of_pair_map(const Eigen::Matrix2d& map);

/// Returns the Rotne-Prager mobility matrix of N spheres on a line, N x N [time/mass]. Positions along the
/// line [length] must increase; spheres may overlap. Radii are in [length], `viscosity` is dynamic
/// [mass/(length time)].
Eigen::MatrixXd rotne_prager_line(std::span<const double> radii, std::span<const double> positions,
                                  double viscosity);

}  // namespace beadswim
