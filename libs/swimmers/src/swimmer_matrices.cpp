#include "beadswim/swimmers/swimmer_matrices.hpp"

#include <optional>

#include "beadswim/swimmers/hinges.hpp"

namespace beadswim {
namespace {

template <int Size>
SwimmerMatrix<Size> zero_matrix(const SwimmerType& type) {
  const auto size = 3 * std::ssize(type.beads);
  return SwimmerMatrix<Size>::Zero(size, size);
}

/// Adds the stiffness of an angular spring with the rest angle 0: K_A B^T B, where B is the derivative of u_2
/// - u_1 by the positions, with the unit vectors u_1 and u_2 along the two sides.
template <int Size>
void add_straight_angle(const Angle& angle, const BeadVectors& positions, SwimmerMatrix<Size>& stiffness) {
  std::array<Eigen::Matrix3d, 3> bend;  // the columns of B for the three beads
  bend.fill(Eigen::Matrix3d::Zero());
  for (int side = 0; side < 2; ++side) {
    const int i = angle.beads[side], j = angle.beads[side + 1];
    const Vec3 along = positions.col(j) - positions.col(i);
    const double length = along.norm();
    const Eigen::Matrix3d dyad = along * along.transpose() / (length * length);
    const Eigen::Matrix3d across = Eigen::Matrix3d::Identity() - dyad;
    const double sign = side == 0 ? -1 : 1;
    bend[side + 1] += sign / length * across;
    bend[side] -= sign / length * across;
  }
  for (int a = 0; a < 3; ++a) {
    for (int b = 0; b < 3; ++b) {
      Eigen::Matrix3d product = bend[a].row(0).transpose() * bend[b].row(0);
      for (int r = 1; r < 3; ++r) product += bend[a].row(r).transpose() * bend[b].row(r);
      stiffness.template block<3, 3>(3 * angle.beads[a], 3 * angle.beads[b]) += angle.stiffness * product;
    }
  }
}

/// Adds the stiffness K_A g g^T of an angular spring with another rest angle, where g is the gradient of the
/// angle by the positions of its beads; none where the beads are in line.
template <int Size>
void add_bent_angle(const Angle& angle, const BeadVectors& positions, SwimmerMatrix<Size>& stiffness) {
  const auto [direction, length, cosine, sine] = sides_of(angle, positions);
  constexpr double smallest_sine = 1e-12;
  if (sine < smallest_sine) return;
  const Vec3 by_1 = -(direction[1] - cosine * direction[0]) / (sine * length[0]),
             by_2 = -(direction[0] - cosine * direction[1]) / (sine * length[1]);
  const std::array<Vec3, 3> gradient{-by_1, by_1 - by_2, by_2};
  for (int a = 0; a < 3; ++a)
    for (int b = 0; b < 3; ++b)
      stiffness.template block<3, 3>(3 * angle.beads[a], 3 * angle.beads[b]) +=
          angle.stiffness * gradient[a] * gradient[b].transpose();
}

}  // namespace

template <int Size>
SwimmerVector<Size> own_forces(const SwimmerType& type, double time, const BeadVectors& positions) {
  const BeadVectors bonds = bond_forces(type, time, positions, zero_vectors(type));
  const BeadVectors angles = angle_forces(type, time, positions);
  return as_vector<Size>(bonds) + as_vector<Size>(angles);
}

template <int Size>
SwimmerMatrix<Size> own_stiffness(const SwimmerType& type, double time, const BeadVectors& positions) {
  SwimmerMatrix<Size> stiffness = zero_matrix<Size>(type);
  for (std::size_t k = 0; k < type.bonds.size(); ++k) {
    const Bond& bond = type.bonds[k];
    const auto [i, j] = bond.beads;
    const Vec3 along = positions.col(j) - positions.col(i);
    const double length = along.norm();
    const Eigen::Matrix3d dyad = along * along.transpose() / (length * length);
    const Eigen::Matrix3d across = Eigen::Matrix3d::Identity() - dyad;
    const Eigen::Matrix3d block =
        bond.stiffness * dyad + bond.stiffness * (1 - rest_length(type, k, time) / length) * across;
    stiffness.template block<3, 3>(3 * i, 3 * i) += block;
    stiffness.template block<3, 3>(3 * j, 3 * j) += block;
    stiffness.template block<3, 3>(3 * i, 3 * j) -= block;
    stiffness.template block<3, 3>(3 * j, 3 * i) -= block;
  }
  std::optional<HingeFit> fit;
  if (has_hinges(type)) fit = fit_hinges(type, time, positions);
  for (std::size_t k = 0; k < type.angles.size(); ++k) {
    const Angle& angle = type.angles[k];
    if (angle.normal) {
      const auto B = hinge_strain(*fit, angle, rest_angle(type, k, time), positions).derivative;
      stiffness += angle.stiffness * B.transpose().lazyProduct(B);
    } else if (rest_angle(type, k, time) == 0) {
      add_straight_angle(angle, positions, stiffness);
    } else {
      add_bent_angle(angle, positions, stiffness);
    }
  }
  return stiffness;
}

template <int Size>
SwimmerMatrix<Size> own_damping(const SwimmerType& type, const BeadVectors& positions) {
  SwimmerMatrix<Size> damping = zero_matrix<Size>(type);
  const BeadVectors still = bond_forces(type, 0, positions, zero_vectors(type));
  for (int c = 0; c < damping.cols(); ++c) {
    BeadVectors velocity = zero_vectors(type);
    velocity(c % 3, c / 3) = 1;
    const BeadVectors moving = bond_forces(type, 0, positions, velocity);
    damping.col(c) = as_vector<Size>(still) - as_vector<Size>(moving);
  }
  return damping;
}

#define BEADSWIM_INSTANTIATE(Size)                                                                  \
  template SwimmerVector<Size> own_forces<Size>(const SwimmerType&, double, const BeadVectors&);    \
  template SwimmerMatrix<Size> own_stiffness<Size>(const SwimmerType&, double, const BeadVectors&); \
  template SwimmerMatrix<Size> own_damping<Size>(const SwimmerType&, const BeadVectors&);
BEADSWIM_INSTANTIATE(size_of_three_beads)
BEADSWIM_INSTANTIATE(Eigen::Dynamic)
#undef BEADSWIM_INSTANTIATE

}  // namespace beadswim
