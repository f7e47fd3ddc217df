#pragma once

#include <Eigen/Core>
#include <optional>

// Linear systems and eigenvalues of dense matrices of any size. The decompositions of Eigen are compiled here
// alone, because their templates take seconds in each file that uses them.

namespace beadswim {

// Return the solution x of a x = b, by Gaussian elimination with partial pivoting.
Eigen::VectorXd solve(const Eigen::MatrixXd& a, const Eigen::VectorXd& b);
Eigen::MatrixXd solve(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b);
Eigen::VectorXcd solve(const Eigen::MatrixXcd& a, const Eigen::VectorXcd& b);

Eigen::MatrixXd inverse(const Eigen::MatrixXd& a);
Eigen::MatrixXcd inverse(const Eigen::MatrixXcd& a);

/// Solutions of a x = b and a^T x = b.
struct PairedSolutions {
  Eigen::MatrixXd direct, transposed;
};
PairedSolutions solve_both(const Eigen::MatrixXd& a, const Eigen::MatrixXd& direct,
                           const Eigen::MatrixXd& transposed);

/// Eigenvalues, in ascending order, and eigenvectors of a symmetric matrix.
struct SymmetricModes {
  explicit SymmetricModes(const Eigen::MatrixXd& matrix);  ///< uses the lower triangle
  Eigen::VectorXd values;
  Eigen::MatrixXd vectors;  ///< one per column
};

/// Returns the lower triangular matrix L with L L^T = matrix (Cholesky); nullopt if the matrix is not
/// positive definite.
std::optional<Eigen::MatrixXd> cholesky_factor(const Eigen::MatrixXd& matrix);

/// Returns the solution x of a x = b for a positive definite matrix.
Eigen::VectorXd solve_definite(const Eigen::MatrixXd& a, const Eigen::VectorXd& b);

/// Returns the x for which the norm of a x - b is smallest; of several, the shortest. For b = 1 it is the
/// pseudoinverse of a.
Eigen::MatrixXd least_squares(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b);

/// Returns an orthonormal basis of the space that the columns of a matrix span.
Eigen::MatrixXd orthonormal_basis(const Eigen::MatrixXd& columns);

}  // namespace beadswim
