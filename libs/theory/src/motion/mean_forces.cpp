#include "beadswim/theory/unsteady_multipole.hpp"

#include <cmath>
#include <numbers>

#include "beadswim/core/complex.hpp"
#include "beadswim/core/gauss_legendre.hpp"
#include "outside_nodes.hpp"

namespace beadswim {

namespace {

using Eigen::MatrixXcd;

/// Returns for each k the matrix of the elements -int_j <xi_j du1/dx> . t^k dS per U_i U_j*, in row i and
/// column j.
std::vector<MatrixXcd> drift_forms(const OscillatingSpheres& unsteady, const OscillatingSpheres& steady,
                                   double viscosity, double angular_frequency) {
  const int count = unsteady.count(), nodes = 2 * unsteady.order() + 4;
  std::vector<MatrixXcd> forms(count, MatrixXcd::Zero(count, count));
  const std::vector<QuadratureNode> rule = gauss_legendre(nodes, -1, 1);
  for (int j = 0; j < count; ++j) {
    const double area = 2 * std::numbers::pi * unsteady.radius(j) * unsteady.radius(j);
    for (const auto& [cosine, weight] : rule) {
      const Eigen::RowVectorXcd shear = unsteady.surface_shear(j, cosine);
      const Eigen::RowVectorXcd traction = viscosity * steady.surface_shear(j, cosine);
      const Complex displacement(0, 1 / angular_frequency);  // xi_j*/U_j* = 1/(i omega)* = i/omega
      for (int k = 0; k < count; ++k) {
        forms[k].col(j) -= (area * weight * cosine * traction[k].real() * displacement) * shear.transpose();
      }
    }
  }
  return forms;
}

/// Returns for each k the matrix of the elements rho int u_i u_j* : grad u^k dV.
std::vector<MatrixXcd> reynolds_forms(const OscillatingSpheres& unsteady, const OscillatingSpheres& steady,
                                      double fluid_density, double depth, int nodes) {
  const int count = unsteady.count();
  std::vector<double> radii, positions;
  for (int i = 0; i < count; ++i) {
    radii.push_back(unsteady.radius(i));
    positions.push_back(unsteady.position(i));
  }
  std::vector<MatrixXcd> forms(count, MatrixXcd::Zero(count, count));
  Eigen::Matrix2Xcd stress(2, count);
  for (const auto& [x, s, weight] : outside_nodes(radii, positions, depth, nodes)) {
    const Eigen::Matrix2Xcd u = unsteady.velocity(x, s);
    const auto towed = steady.at(x, s).gradient.real().eval();
    for (int k = 0; k < count; ++k) {
      const double shear = (towed(1, k) + towed(2, k)) / 2;
      Eigen::Matrix2d strain;
      strain << towed(0, k), shear, shear, towed(3, k);
      stress = (fluid_density * weight * strain).lazyProduct(u.conjugate());
      forms[k] += u.transpose().lazyProduct(stress);
    }
  }
  return forms;
}

}  // namespace

MeanForces mean_forces(const OscillatingSpheres& unsteady, const OscillatingSpheres& steady, double viscosity,
                       double angular_frequency, int nodes) {
  const double alpha = std::abs(unsteady.alpha());  // |alpha|^2 = omega rho/eta = 2/depth^2
  return {.resistance = steady.resistance().real(),
          .drift = drift_forms(unsteady, steady, viscosity, angular_frequency),
          .reynolds = reynolds_forms(unsteady, steady, viscosity * alpha * alpha / angular_frequency,
                                     std::sqrt(2.0) / alpha, nodes)};
}

double mean_of(const Eigen::MatrixXcd& form, const Eigen::VectorXcd& u, const Eigen::VectorXcd& w) {
  return (u.transpose() * form * w.conjugate()).value().real() / 2;
}

}  // namespace beadswim
