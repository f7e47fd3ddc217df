#include "beadswim/mobility/force_moments.hpp"

#include <cmath>
#include <numbers>

#include "beadswim/collinear/pair_mobility.hpp"
#include "beadswim/core/gauss_legendre.hpp"

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

Eigen::Matrix3d stresslet_of(const double* coefficients) {
  Eigen::Matrix3d stresslet = Eigen::Matrix3d::Zero();
  for (int m = 0; m < 5; ++m) stresslet += coefficients[m] * basis()[m];
  return stresslet;
}

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

using MomentMatrix = Eigen::Matrix<double, moment_count(max_moment_order), moment_count(max_moment_order)>;

/// Returns the mean over all directions n of the product of the transverse parts of F, S n and Q : nn, for
/// each pair of basis elements. F and Q do not couple with S.
const MomentMatrix& transverse_mean() {
  static const MomentMatrix all = [] {
    MomentMatrix mean = MomentMatrix::Zero();
    constexpr int heights = 8, angles = 16;  // exact for polynomials of degree 6
    for (const auto& [height, weight] : gauss_legendre(heights, -1, 1)) {
      for (int k = 0; k < angles; ++k) {
        const double phi = 2 * std::numbers::pi * k / angles, rho = std::sqrt(1 - height * height);
        const Eigen::Vector3d n(rho * std::cos(phi), rho * std::sin(phi), height);
        Eigen::Matrix<double, 3, moment_count(max_moment_order)> force =
            Eigen::Matrix<double, 3, moment_count(max_moment_order)>::Zero();
        force.leftCols<3>().setIdentity();
        for (int m = 0; m < 5; ++m) {
          force.col(3 + m) = basis()[m] * n;
          for (int c = 0; c < 3; ++c) force(c, 8 + 5 * c + m) = n.dot(basis()[m] * n);
        }
        force -= n * (n.transpose() * force).eval();
        mean += weight / (2 * angles) * force.transpose() * force;
      }
    }
    mean.block<5, 3>(3, 0).setZero();
    mean.block<3, 5>(0, 3).setZero();
    mean.block<5, 15>(3, 8).setZero();
    mean.block<15, 5>(8, 3).setZero();
    return mean;
  }();
  return all;
}

/// Returns the self-mobility by `integrals` of products of the form factors of each pair of degrees over the
/// wavenumber.
Eigen::MatrixXd self_mobility_of(const Eigen::Matrix3d& integrals, int order, double viscosity) {
  const int count = moment_count(order);
  Eigen::MatrixXd mobility = transverse_mean().topLeftCorner(count, count);
  for (int m = 0; m < count; ++m)
    for (int k = 0; k < count; ++k)
      mobility(m, k) *= integrals(degree_of_moment(m), degree_of_moment(k)) /
                        (2 * std::numbers::pi * std::numbers::pi * viscosity);
  return mobility;
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
    const Eigen::Matrix<double, 15, 15> mean = transverse_mean().block<15, 15>(8, 8);
    mobility.block<15, 15>(8, 8) = mean / (20 * std::numbers::pi * viscosity * radius);
  }
  return mobility;
}

// The Fourier transform of the moments has the factors j_0(ka), 3 j_1(ka)/a and -j_2(ka).
Eigen::MatrixXd moment_self_mobility_below(double wavenumber, int order, double radius, double viscosity) {
  Eigen::Matrix3d integrals = Eigen::Matrix3d::Zero();
  const int panels = static_cast<int>(std::ceil(wavenumber * radius));
  for (int p = 0; p < panels; ++p) {
    for (const auto& [k, weight] :
         gauss_legendre(10, wavenumber * p / panels, wavenumber * (p + 1) / panels)) {
      const double x = k * radius;
      const Eigen::Vector3d factors(std::sph_bessel(0, x), 3 * std::sph_bessel(1, x) / radius,
                                    -std::sph_bessel(2, x));
      integrals += weight * factors * factors.transpose();
    }
  }
  return self_mobility_of(integrals, order, viscosity);
}

Eigen::MatrixXd far_moment_self_mobility(const std::array<double, 4>& far_integrals, int order, double radius,
                                         double viscosity) {
  const double a2 = radius * radius;
  const std::array factors{1.0, 1.0, -a2 / 15};  // of k^l
  Eigen::Matrix3d integrals = Eigen::Matrix3d::Zero();
  for (int l = 0; l <= max_moment_order; ++l)
    for (int m = l % 2; m <= max_moment_order; m += 2)  // moments of odd sums l + m do not couple
      integrals(l, m) = factors[l] * factors[m] *
                        (far_integrals[(l + m) / 2] -
                         (size_factors[l] + size_factors[m]) * a2 * far_integrals[(l + m) / 2 + 1]);
  return self_mobility_of(integrals, order, viscosity);
}

}  // namespace beadswim
