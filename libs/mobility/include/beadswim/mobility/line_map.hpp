#pragma once

#include <Eigen/Core>
#include <span>

// clang-format off
// Map S of the forces f on N spheres on a line. With S, an approximate mobility M_r of the spheres gives the
// velocities of the exact mobility M_x. Forces and velocities are along the line:
//
//   S^T M_r S f = M_x f    for all forces f that sum to zero,    1^T S = 1^T
//
//   S = B (A_r^-1 # A_x) B^T (I - n_x 1^T) + n_r 1^T,      A = B^T M B,      n = M^-1 1 / (1^T M^-1 1)
//
//   B  orthonormal basis of the forces that sum to zero, N x (N - 1)
//   n  forces of sum 1 under which all spheres have the same velocity
//   1  vector of N ones
//   r, x   indices of A and n: evaluated with M = M_r or M = M_x
//   #  geometric mean of two positive definite matrices: G = A_r^-1 # A_x is the positive definite solution of
//      G A_r G = A_x
//
// S conserves the sum of the forces, so the leading term of the flow far from the spheres is unchanged. S^T
// leaves velocities unchanged if they are equal for all spheres. S is never singular, so S^T M_r S is
// positive definite if M_r is. Under the forces n_x, S^T M_r S gives all spheres the same velocity, the one
// that M_r gives under the forces n_r.
//
// Page: docs/method/near-field.md. Geometric mean: Bhatia, Positive Definite Matrices (Princeton 2007),
// chapter 4.
// clang-format on

namespace beadswim {

/// Returns S for M_x = exact and M_r = approximate. Both must be N x N, symmetric and positive definite, in
/// the same unit. If they are not, the result is non-finite.
Eigen::MatrixXd line_map(const Eigen::MatrixXd& exact, const Eigen::MatrixXd& approximate);

/// Returns log S of two spheres for map = S. Each column of S - I sums to zero, so S - I has rank one.
/// Therefore log S = log(s)/(s - 1) (S - I) with s = 1 + trace(S - I).
Eigen::Matrix2d log_of_pair_map(const Eigen::Matrix2d& map);

/// Returns the Rotne-Prager mobility of spheres on a line [time/mass]. Positions [length] must increase;
/// spheres may overlap. `viscosity` is dynamic [mass/(length time)].
Eigen::MatrixXd rotne_prager_line(std::span<const double> radii, std::span<const double> positions,
                                  double viscosity);

}  // namespace beadswim
