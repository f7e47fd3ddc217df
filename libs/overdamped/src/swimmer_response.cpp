#include "swimmer_response.hpp"

#include "beadswim/mobility/rotne_prager_tensor.hpp"

namespace beadswim {
namespace {

const BeadVectors at_rest{Vec3::Zero(), Vec3::Zero(), Vec3::Zero()};

}  // namespace

Vector9 own_forces(const SwimmerType& type, const BeadVectors& positions) {
  const BeadVectors spring = spring_forces(type.springs, positions, at_rest);
  const BeadVectors bending = angular_spring_forces(type.angular_stiffness, positions);
  return as_vector(spring) + as_vector(bending);
}

Matrix9 own_mobility(const SwimmerType& type, const BeadVectors& positions, double viscosity) {
  Matrix9 mobility = Matrix9::Zero();
  for (int i = 0; i < 3; ++i) {
    mobility.block<3, 3>(3 * i, 3 * i).diagonal().setConstant(self_mobility(type.beads[i].radius, viscosity));
    for (int j = 0; j < i; ++j) {
      const Vec3 d = positions[i] - positions[j];
      const PairTensor tensor =
          rotne_prager_tensor(type.beads[i].radius, type.beads[j].radius, d.norm(), viscosity);
      Eigen::Matrix3d block = tensor.axial / d.squaredNorm() * d * d.transpose();
      block.diagonal().array() += tensor.isotropic;
      mobility.block<3, 3>(3 * i, 3 * j) = mobility.block<3, 3>(3 * j, 3 * i) = block;
    }
  }
  return mobility;
}

Matrix9 own_stiffness(const SwimmerType& type, const BeadVectors& positions) {
  Matrix9 stiffness = Matrix9::Zero();
  Eigen::Matrix<double, 3, 9> bend =
      Eigen::Matrix<double, 3, 9>::Zero();  // d(u_2 - u_1)/dx, u: arm directions
  for (int arm = 0; arm < 2; ++arm) {
    const Vec3 along = positions[arm + 1] - positions[arm];
    const double length = along.norm();
    const Eigen::Matrix3d dyad = along * along.transpose() / (length * length);
    const Eigen::Matrix3d across = Eigen::Matrix3d::Identity() - dyad;
    const Spring& spring = type.springs[arm];
    const Eigen::Matrix3d block =
        spring.stiffness * dyad + spring.stiffness * (1 - spring.rest_length / length) * across;
    const int one = 3 * arm, other = 3 * arm + 3;
    stiffness.block<3, 3>(one, one) += block;
    stiffness.block<3, 3>(other, other) += block;
    stiffness.block<3, 3>(one, other) -= block;
    stiffness.block<3, 3>(other, one) -= block;
    const double sign = arm == 0 ? -1 : 1;
    bend.block<3, 3>(0, other) += sign / length * across;
    bend.block<3, 3>(0, one) -= sign / length * across;
  }
  return stiffness + type.angular_stiffness * bend.transpose() * bend;
}

Matrix9 own_damping(const SwimmerType& type, const BeadVectors& positions) {
  const Vector9 without = as_vector(spring_forces(type.springs, positions, at_rest));
  Matrix9 damping;
  for (int c = 0; c < 9; ++c) {
    BeadVectors velocity = at_rest;
    velocity[c / 3][c % 3] = 1;
    damping.col(c) = without - as_vector(spring_forces(type.springs, positions, velocity));
  }
  return damping;
}

}  // namespace beadswim
