#include "beadswim/core/dense_systems.hpp"

#include <Eigen/Dense>

namespace beadswim {

Eigen::VectorXd solve(const Eigen::MatrixXd& a, const Eigen::VectorXd& b) {
  return a.partialPivLu().solve(b);
}

Eigen::MatrixXd solve(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b) {
  return a.partialPivLu().solve(b);
}

Eigen::VectorXcd solve(const Eigen::MatrixXcd& a, const Eigen::VectorXcd& b) {
  return a.partialPivLu().solve(b);
}

Eigen::MatrixXd inverse(const Eigen::MatrixXd& a) {
  return a.inverse();
}

Eigen::MatrixXcd inverse(const Eigen::MatrixXcd& a) {
  return a.inverse();
}

PairedSolutions solve_both(const Eigen::MatrixXd& a, const Eigen::MatrixXd& direct,
                           const Eigen::MatrixXd& transposed) {
  const Eigen::PartialPivLU<Eigen::MatrixXd> lu(a);
  return {.direct = lu.solve(direct), .transposed = lu.transpose().solve(transposed)};
}

SymmetricModes::SymmetricModes(const Eigen::MatrixXd& matrix) {
  if (matrix.size() == 0) return;
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(matrix);
  values = solver.eigenvalues();
  vectors = solver.eigenvectors();
}

std::optional<Eigen::MatrixXd> cholesky_factor(const Eigen::MatrixXd& matrix) {
  const Eigen::LLT<Eigen::MatrixXd> decomposition(matrix);
  if (decomposition.info() != Eigen::Success) return std::nullopt;
  return decomposition.matrixL();
}

Eigen::VectorXd solve_definite(const Eigen::MatrixXd& a, const Eigen::VectorXd& b) {
  return a.ldlt().solve(b);
}

Eigen::MatrixXd least_squares(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b) {
  return a.completeOrthogonalDecomposition().solve(b);
}

Eigen::MatrixXd orthonormal_basis(const Eigen::MatrixXd& columns) {
  return columns.householderQr().householderQ() * Eigen::MatrixXd::Identity(columns.rows(), columns.cols());
}

}  // namespace beadswim
