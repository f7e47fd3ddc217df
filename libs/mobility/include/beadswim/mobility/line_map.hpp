#pragma once

#include <Eigen/Core>
#include <span>

// clang-format off
// A map S of forces on N spheres in a row, under which an approximate mobility M_r does to them what the exact one
// M_x does, forces and velocities along the row:
//
//   S^T M_r S f = M_x f    for all forces f that sum to zero,    1^T S = 1^T
//
//   S = B (A_r^-1 # A_x) B^T (I - n_x 1^T) + n_r 1^T,      A = B^T M B,      n = M^-1 1 / (1^T M^-1 1)
//
// B  an orthonormal basis of the forces that sum to zero, N x (N - 1)
// n  forces, of sum 1, under which all spheres move alike
// #  geometric mean of two positive definite matrices: G = A_r^-1 # A_x is the one such that solves G A_r G = A_x
//
// S keeps the sum of the forces, so that far flows have their leading term; S^T keeps velocities that are all alike.
// It is never singular: S^T M_r S is positive definite where M_r is. To a force that all share it answers as M_r.
//
// Page: docs/method/near-field.md. Geometric mean: Bhatia, Positive Definite Matrices (Princeton 2007), ch. 4.
// clang-format on

namespace beadswim {

/// S. Both mobilities [of one unit] are symmetric and positive definite, N x N; not finite if they are not.
Eigen::MatrixXd line_map(const Eigen::MatrixXd& exact, const Eigen::MatrixXd& approximate);

/// log S of two spheres, from S. As S - I takes its first column from the second, both of rank one,
/// log S = log(s)/(s - 1) (S - I), s = 1 + trace(S - I).
Eigen::Matrix2d log_of_pair_map(const Eigen::Matrix2d& map);

/// Rotne-Prager mobility of spheres on a line, increasing positions; overlapping ones too.
Eigen::MatrixXd rotne_prager_line(std::span<const double> radii, std::span<const double> positions,
                                  double viscosity);

}  // namespace beadswim
