#pragma once

#include <Eigen/Core>
#include <span>

// clang-format off
// A map S of the forces on N spheres on a line. With S, an approximate mobility M_r of the spheres gives the
// velocities of the exact mobility M_x, where forces and velocities are along the line:
//
//   S^T M_r S f = M_x f    for all forces f that sum to zero,    1^T S = 1^T
//
//   S = B (A_r^-1 # A_x) B^T (I - n_x 1^T) + n_r 1^T,      A = B^T M B,      n = M^-1 1 / (1^T M^-1 1)
//
//   B  orthonormal basis of the forces that sum to zero, N x (N - 1)
//   n  forces of sum 1 under which all spheres have the same velocity
//   #  geometric mean of two positive definite matrices: G = A_r^-1 # A_x is the positive definite solution of
//      G A_r G = A_x
//
// S conserves the sum of the forces, so the leading term of the far flow is unchanged. S^T maps equal
// velocities to themselves. S is never singular: S^T M_r S is positive definite if M_r is. Under the forces
// n_x all spheres have the velocity that M_r gives for the same total force.
//
// Page: docs/method/near-field.md. Geometric mean: Bhatia, Positive Definite Matrices (Princeton 2007), ch.
// 4.
// clang-format on

namespace beadswim {

/// Returns S. Both mobilities must be N x N, symmetric and positive definite, in the same unit. Returns
/// non-finite values otherwise.
Eigen::MatrixXd line_map(const Eigen::MatrixXd& exact, const Eigen::MatrixXd& approximate);

/// Returns log S of two spheres. Each column of S - I sums to zero, so S - I has rank one, and
/// log S = log(s)/(s - 1) (S - I) with s = 1 + trace(S - I).
Eigen::Matrix2d log_of_pair_map(const Eigen::Matrix2d& map);

/// Returns the Rotne-Prager mobility of spheres on a line [time/mass]. Positions [length] increase; spheres
/// may overlap.
Eigen::MatrixXd rotne_prager_line(std::span<const double> radii, std::span<const double> positions,
                                  double viscosity);

}  // namespace beadswim
