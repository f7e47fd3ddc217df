#pragma once

#include <Eigen/Core>

#include "beadswim/collinear/rotne_prager.hpp"

namespace beadswim {

/// Mobility tensor of two spheres of radii a_i and a_j at the distance r of their centres [length], in open
/// space. eta: dynamic viscosity [mass/(length time)].
using PairTensorLaw = PairTensor (*)(double a_i, double a_j, double r, double eta);

/// Returns the mobility matrix of spheres in open space [time/mass] that `law`, a PairTensorLaw, gives for
/// pairs; the mobility of a sphere by its own force is that of a lone sphere. Rows and columns are the
/// components x, y, z of sphere 1, then of sphere 2, and so on.
///   spheres    a list of elements with the member radius [length]
///   positions  centres of the spheres, one column for each [length]
///   viscosity  dynamic [mass/(length time)]
template <class Matrix>
Matrix mobility_matrix(const auto& law, const auto& spheres, const auto& positions, double viscosity) {
  const Eigen::Index size = 3 * positions.cols();
  Matrix mobility = Matrix::Zero(size, size);
  for (Eigen::Index i = 0; i < positions.cols(); ++i) {
    mobility.template block<3, 3>(3 * i, 3 * i)
        .diagonal()
        .setConstant(self_mobility(spheres[i].radius, viscosity));
    for (Eigen::Index j = 0; j < i; ++j) {
      const Vec3 d = positions.col(i) - positions.col(j);
      const PairTensor tensor = law(spheres[i].radius, spheres[j].radius, d.norm(), viscosity);
      Eigen::Matrix3d block = tensor.axial / d.squaredNorm() * d * d.transpose();
      block.diagonal().array() += tensor.isotropic;
      mobility.template block<3, 3>(3 * i, 3 * j) = mobility.template block<3, 3>(3 * j, 3 * i) = block;
    }
  }
  return mobility;
}

}  // namespace beadswim
