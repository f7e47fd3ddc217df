#include "beadswim/mobility/line_map.hpp"

#include <cmath>

#include "beadswim/collinear/rotne_prager.hpp"
#include "beadswim/core/dense_systems.hpp"

namespace beadswim {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Returns an n x (n - 1) matrix of orthonormal columns that sum to zero. Column k, counted from 0, has k + 1
/// equal entries, followed by one entry of the opposite sign (Helmert matrix).
MatrixXd zero_sum_basis(Eigen::Index n) {
  MatrixXd basis = MatrixXd::Zero(n, n - 1);
  for (Eigen::Index k = 0; k < n - 1; ++k) {
    basis.col(k).head(k + 1).setOnes();
    basis(k + 1, k) = -static_cast<double>(k + 1);
    basis.col(k).normalize();
  }
  return basis;
}

/// Returns the forces of sum 1 under which all spheres have the same velocity, for the mobility matrix
/// `mobility`.
VectorXd uniform_velocity_forces(const MatrixXd& mobility) {
  const VectorXd forces = inverse(mobility) * VectorXd::Ones(mobility.rows());
  return forces / forces.sum();
}

/// Returns the geometric mean G = A^-1 # X, which is the positive definite solution of G A G = X.
MatrixXd riccati_root(const MatrixXd& a, const MatrixXd& x) {
  const MatrixRoot of_a(a), of_product(of_a.root * x * of_a.root);
  return of_a.inverse * of_product.root * of_a.inverse;
}

}  // namespace

MatrixXd line_map(const MatrixXd& exact, const MatrixXd& approximate) {
  const Eigen::Index n = exact.rows();
  const MatrixXd basis = zero_sum_basis(n);
  const MatrixXd relative =
      riccati_root(basis.transpose() * approximate * basis, basis.transpose() * exact * basis);
  const Eigen::RowVectorXd ones = Eigen::RowVectorXd::Ones(n);
  return basis * relative * basis.transpose() *
             (MatrixXd::Identity(n, n) - uniform_velocity_forces(exact) * ones) +
         uniform_velocity_forces(approximate) * ones;
}

Eigen::Matrix2d log_of_pair_map(const Eigen::Matrix2d& map) {
  const Eigen::Matrix2d change = map - Eigen::Matrix2d::Identity();
  const double excess = change.trace();  // s - 1
  return (excess == 0 ? 1 : std::log1p(excess) / excess) * change;
}

MatrixXd rotne_prager_line(std::span<const double> radii, std::span<const double> positions,
                           double viscosity) {
  const auto n = std::ssize(radii);
  MatrixXd mobility(n, n);
  for (Eigen::Index i = 0; i < n; ++i) {
    mobility(i, i) = self_mobility(radii[i], viscosity);
    for (Eigen::Index j = 0; j < i; ++j)
      mobility(i, j) = mobility(j, i) =
          rotne_prager(radii[i], radii[j], positions[i] - positions[j], viscosity).value;
  }
  return mobility;
}

}  // namespace beadswim
