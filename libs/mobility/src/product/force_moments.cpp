#include "beadswim/mobility/force_moments.hpp"

#include <cmath>
#include <numbers>

#include "beadswim/mobility/gauss_legendre.hpp"
#include "beadswim/mobility/pair_mobility.hpp"

namespace beadswim {
namespace {

/// Orthonormal basis of symmetric traceless tensors: xx - yy, 2 zz - xx - yy, xy, xz, yz.
const std::array<Eigen::Matrix3d, 5>& basis() {
  static const std::array<Eigen::Matrix3d, 5> tensors = [] {
    std::array<Eigen::Matrix3d, 5> b;
    b.fill(Eigen::Matrix3d::Zero());
    b[0].diagonal() << 1, -1, 0;
    b[1].diagonal() << -1, -1, 2;
    b[2](0, 1) = b[2](1, 0) = b[3](0, 2) = b[3](2, 0) = b[4](1, 2) = b[4](2, 1) = 1;
    for (Eigen::Matrix3d& tensor : b) tensor /= tensor.norm();
    return b;
  }();
  return tensors;
}

/// Returns the component of a symmetric tensor that belongs to derivative d of order 2. A mixed derivative
/// stands for two equal components.
double component(const Eigen::Matrix3d& tensor, int d) {
  const auto& degree = derivative_table.degree[d];
  for (int a = 0; a < 3; ++a)
    if (degree[a] == 2) return tensor(a, a);
  const int absent = degree[0] == 0 ? 0 : (degree[1] == 0 ? 1 : 2);
  return 2 * tensor((absent + 1) % 3, (absent + 2) % 3);
}

}  // namespace

void source_of_moments(int order, double radius, const double* moments, double* source) {
  const int count = derivative_count(order);
  for (int c = 0; c < 3; ++c) {
    double* const of_component = source + c * count;
    of_component[0] = moments[c];
    for (int d = 1; d < count; ++d) of_component[d] = 0;
    for (int m = 0; m < 5 && order >= 1; ++m)
      for (int g = 0; g < 3; ++g) of_component[1 + g] -= moments[3 + m] * basis()[m](c, g);
    for (int m = 0; m < 5 && order >= 2; ++m)
      for (int d = 4; d < 10; ++d)
        of_component[d] += radius * radius / 15 * moments[8 + 5 * c + m] * component(basis()[m], d);
  }
}

void project_flow(int order, double radius, const double* flow, double* projections) {
  const int count = derivative_count(order);
  for (int m = 0; m < moment_count(order); ++m) projections[m] = 0;
  for (int c = 0; c < 3; ++c) {
    const double* const of_component = flow + c * count;
    projections[c] = of_component[0];
    for (int m = 0; m < 5 && order >= 1; ++m)
      for (int g = 0; g < 3; ++g) projections[3 + m] += of_component[1 + g] * basis()[m](c, g);
    for (int m = 0; m < 5 && order >= 2; ++m)
      for (int d = 4; d < 10; ++d)
        projections[8 + 5 * c + m] += radius * radius / 15 * of_component[d] * component(basis()[m], d);
  }
}

namespace {

/// Returns the mean over all directions n of the product of the transverse parts of Q : nn, for each pair of
/// basis elements of Q.
Eigen::Matrix<double, 15, 15> transverse_mean() {
  Eigen::Matrix<double, 15, 15> mean = Eigen::Matrix<double, 15, 15>::Zero();
  constexpr int heights = 8, angles = 16;  // exact for polynomials of degree 6
  for (const auto& [height, weight] : gauss_legendre(heights, -1, 1)) {
    for (int k = 0; k < angles; ++k) {
      const double phi = 2 * std::numbers::pi * k / angles, rho = std::sqrt(1 - height * height);
      const Eigen::Vector3d n(rho * std::cos(phi), rho * std::sin(phi), height);
      Eigen::Matrix<double, 3, 15> force = Eigen::Matrix<double, 3, 15>::Zero();
      for (int c = 0; c < 3; ++c)
        for (int m = 0; m < 5; ++m) force(c, 5 * c + m) = n.dot(basis()[m] * n);
      force -= n * (n.transpose() * force).eval();
      mean += weight / (2 * angles) * force.transpose() * force;
    }
  }
  return mean;
}

}  // namespace

// The integral of j_l(ka)^2 over k is pi/(2 (2 l + 1) a). Moments of different degree do not couple.
Eigen::MatrixXd moment_self_mobility(int order, double radius, double viscosity) {
  const int count = moment_count(order);
  Eigen::MatrixXd mobility = Eigen::MatrixXd::Zero(count, count);
  mobility.topLeftCorner<3, 3>().diagonal().setConstant(self_mobility(radius, viscosity));
  if (order >= 1)
    mobility.block<5, 5>(3, 3).diagonal().setConstant(
        3 / (20 * std::numbers::pi * viscosity * std::pow(radius, 3)));
  if (order >= 2) {
    static const Eigen::Matrix<double, 15, 15> mean = transverse_mean();
    mobility.block<15, 15>(8, 8) = mean / (20 * std::numbers::pi * viscosity * radius);
  }
  return mobility;
}

}  // namespace beadswim
