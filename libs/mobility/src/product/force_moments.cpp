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

/// Returns the component of a symmetric tensor that belongs to derivatives[d], where d >= 4.
double component(const Eigen::Matrix3d& tensor, int d) {
  constexpr std::array<std::array<int, 2>, 6> places{{{0, 0}, {0, 1}, {0, 2}, {1, 1}, {1, 2}, {2, 2}}};
  return tensor(places[d - 4][0], places[d - 4][1]);
}

/// Returns 2 for mixed derivatives, which stand for two components of a symmetric tensor, otherwise 1.
double multiplicity(int d) {
  return d == 5 || d == 6 || d == 8 ? 2 : 1;
}

}  // namespace

void derivatives_of_moments(int order, double radius, const double* moments, double* result) {
  const int count = derivative_count(order);
  for (int c = 0; c < 3; ++c) {
    double* const of_component = result + c * count;
    of_component[0] = moments[c];
    for (int d = 1; d < count; ++d) of_component[d] = 0;
    for (int m = 0; m < 5 && order >= 1; ++m)
      for (int g = 0; g < 3; ++g) of_component[1 + g] -= moments[3 + m] * basis()[m](c, g);
    for (int m = 0; m < 5 && order >= 2; ++m)
      for (int d = 4; d < 10; ++d)
        of_component[d] +=
            radius * radius / 15 * moments[8 + 5 * c + m] * multiplicity(d) * component(basis()[m], d);
  }
}

void moments_of_derivatives(int order, double radius, const double* flow, double* moments) {
  const int count = derivative_count(order);
  for (int m = 0; m < moment_count(order); ++m) moments[m] = 0;
  for (int c = 0; c < 3; ++c) {
    const double* const of_component = flow + c * count;
    moments[c] = of_component[0];
    for (int m = 0; m < 5 && order >= 1; ++m)
      for (int g = 0; g < 3; ++g) moments[3 + m] += of_component[1 + g] * basis()[m](c, g);
    for (int m = 0; m < 5 && order >= 2; ++m)
      for (int d = 4; d < 10; ++d)
        moments[8 + 5 * c + m] +=
            radius * radius / 15 * of_component[d] * multiplicity(d) * component(basis()[m], d);
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
