#pragma once

#include <Eigen/Core>
#include <array>
#include <numbers>
#include <vector>

#include "beadswim/core/gauss_legendre.hpp"
#include "beadswim/mobility/force_moments.hpp"

// Integrals over the surface of a sphere, for tests of force moments.

namespace beadswim {

struct SurfaceNode {
  Eigen::Vector3d normal;
  double weight;  ///< the sum over a sphere is 1
};

inline std::vector<SurfaceNode> sphere_nodes(int heights) {
  std::vector<SurfaceNode> nodes;
  for (const auto& [z, weight] : gauss_legendre(heights, -1, 1)) {
    for (int k = 0; k < 2 * heights; ++k) {
      const double phi = std::numbers::pi * k / heights, rho = std::sqrt(1 - z * z);
      nodes.push_back({{rho * std::cos(phi), rho * std::sin(phi), z}, weight / (4.0 * heights)});
    }
  }
  return nodes;
}

/// Returns the force densities of all moments at a normal, times the area: one column per moment.
inline Eigen::MatrixXd moment_densities(int order, double radius, const Eigen::Vector3d& n) {
  std::array<Eigen::Matrix3d, 5> basis;
  basis.fill(Eigen::Matrix3d::Zero());
  basis[0].diagonal() << 1, -1, 0;
  basis[1].diagonal() << -1, -1, 2;
  basis[2](0, 1) = basis[2](1, 0) = basis[3](0, 2) = basis[3](2, 0) = basis[4](1, 2) = basis[4](2, 1) = 1;
  for (Eigen::Matrix3d& tensor : basis) tensor /= tensor.norm();
  Eigen::MatrixXd f = Eigen::MatrixXd::Zero(3, moment_count(order));
  f.leftCols<3>().setIdentity();
  for (int m = 0; m < 5 && order >= 1; ++m) f.col(3 + m) = 3 / radius * basis[m] * n;
  for (int c = 0; c < 3 && order >= 2; ++c)
    for (int m = 0; m < 5; ++m) f(c, 8 + 5 * c + m) = n.dot(basis[m] * n);
  return f;
}

}  // namespace beadswim
