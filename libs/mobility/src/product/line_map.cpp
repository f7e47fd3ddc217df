#include "beadswim/mobility/line_map.hpp"

#include <Eigen/LU>
#include <cmath>
#include <numbers>

#include "beadswim/collinear/rotne_prager.hpp"

namespace beadswim {
namespace {

template <int N>
using LineVector = Eigen::Matrix<double, N, 1>;

/// Returns an N x (N - 1) matrix of orthonormal columns that sum to zero. Column k, counted from 0, has k + 1
/// equal entries, followed by one entry of the opposite sign (Helmert matrix).
template <int N>
Eigen::Matrix<double, N, N - 1> zero_sum_basis() {
  Eigen::Matrix<double, N, N - 1> basis = Eigen::Matrix<double, N, N - 1>::Zero();
  for (int k = 0; k < N - 1; ++k) {
    basis.col(k).head(k + 1).setOnes();
    basis(k + 1, k) = -static_cast<double>(k + 1);
    basis.col(k).normalize();
  }
  return basis;
}

/// Forces of sum 1 under which all spheres have the same velocity, and this velocity.
template <int N>
struct Towing {
  explicit Towing(const LineMatrix<N>& mobility) : forces(mobility.inverse() * LineVector<N>::Ones()) {
    velocity = 1 / forces.sum();
    forces *= velocity;
  }
  LineVector<N> forces;
  double velocity;
};

/// Returns the geometric mean G = a^-1 # x, which is the positive definite solution of G a G = x. For
/// matrices of size m = 1 or 2, it is proportional to the sum Y of a^-1 and x, each divided by det^(1/m), and
/// has the determinant sqrt(det x/det a).
template <class Matrix>
Matrix riccati_root(const Matrix& a, const Matrix& x) {
  const auto scale = [](const Matrix& m) { return std::pow(m.determinant(), 1.0 / m.rows()); };
  const double of_a = scale(a), of_x = scale(x);
  const Matrix Y = of_a * a.inverse() + x / of_x;
  return std::sqrt(of_x / of_a) / scale(Y) * Y;
}

}  // namespace

template <int N>
LineMap<N> line_map(const LineMatrix<N>& exact, const LineMatrix<N>& approximate) {
  const auto basis = zero_sum_basis<N>();
  const LineMatrix<N - 1> A_r = basis.transpose() * approximate * basis,
                          A_x = basis.transpose() * exact * basis;
  const auto ones = LineVector<N>::Ones().transpose();
  const Towing<N> of_exact(exact), of_approximate(approximate);
  return {basis * riccati_root(A_r, A_x) * basis.transpose() *
                  (LineMatrix<N>::Identity() - of_exact.forces * ones) +
              of_approximate.forces * ones,
          of_approximate.velocity - of_exact.velocity};
}

LineMatrix<2> log_of_pair_map(const LineMatrix<2>& map) {
  const LineMatrix<2> change = map - LineMatrix<2>::Identity();
  const double excess = change.trace();  // s - 1
  return (excess == 0 ? 1 : std::log1p(excess) / excess) * change;
}

template <int N>
LineMatrix<N> strained_line(const std::array<double, N>& radii, const std::array<double, N>& positions,
                            double viscosity, double (*weight)(double)) {
  LineMatrix<N> M, M_HF = LineMatrix<N>::Zero(), M_HH, K = M_HF;
  for (int i = 0; i < N; ++i) {
    const double a = radii[i];
    M(i, i) = self_mobility(a, viscosity);
    M_HH(i, i) = 3 / (20 * std::numbers::pi * viscosity * a * a * a);
    for (int j = 0; j < N; ++j) {
      if (j == i) continue;
      const double b = radii[j], x = positions[i] - positions[j], r = std::abs(x);
      const double unit = 1 / (8 * std::numbers::pi * viscosity * r * r);
      M(i, j) = rotne_prager(a, b, r, viscosity).value;
      M_HF(i, j) =
          std::copysign(std::sqrt(2.0 / 3), x) * (18 * (a * a / 10 + b * b / 6) / (r * r) - 3) * unit;
      M_HH(i, j) = (36.0 / 5 * (a * a + b * b) / (r * r) - 6) * unit / r;
      K(i, j) = weight(2 * r / (a + b)) * M_HF(i, j) / M_HH(i, i);
    }
  }
  const LineMatrix<N> induced = K.transpose() * M_HF;
  return M - induced - induced.transpose() + K.transpose() * M_HH * K;
}

template LineMap<2> line_map(const LineMatrix<2>&, const LineMatrix<2>&);
template LineMap<3> line_map(const LineMatrix<3>&, const LineMatrix<3>&);
template LineMatrix<2> strained_line<2>(const std::array<double, 2>&, const std::array<double, 2>&, double,
                                        double (*)(double));
template LineMatrix<3> strained_line<3>(const std::array<double, 3>&, const std::array<double, 3>&, double,
                                        double (*)(double));

}  // namespace beadswim
