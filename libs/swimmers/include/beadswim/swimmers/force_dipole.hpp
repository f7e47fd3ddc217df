#pragma once

#include <Eigen/Core>
#include <array>

#include "beadswim/core/fields.hpp"
#include "beadswim/swimmers/swimmer_shape.hpp"

// clang-format off
// Force dipole of a swimmer, the stresslet that it exerts on the fluid:
//
//   S = sum_i [ (x_i - x_m) F_i ]^ + S_i,   [ T ]^ = (T + T^T)/2 - I tr T/3
//
//   x_i, x_m  position of bead i, mean position of all beads [length]
//   F_i, S_i  force and stresslet that bead i exerts on the fluid [force, force length]
//
// Its strength along the axis e is p = 3/2 e.S.e: two forces F and -F along e, a distance d apart, have p = F d.
// Page: docs/method/force-dipole.md.
// clang-format on

namespace beadswim {

/// Components xx, yy, zz, xy, xz, yz of a symmetric tensor.
using SymmetricTensor = std::array<double, 6>;

/// Mean force dipole of a swimmer in a cycle, in the frame of its orientation [mass length^2/time^2].
struct ForceDipole {
  double axial = 0;  ///< p along the axis; positive for a pusher, negative for a puller
  SymmetricTensor tensor{};

  double* data() { return tensor.data(); }  ///< axial follows from the tensor: dipole_in_frame()
  std::size_t size() const { return tensor.size(); }

  BEADSWIM_FIELDS(axial, tensor)
};

inline SymmetricTensor components_of(const Eigen::Matrix3d& s) {
  return {s(0, 0), s(1, 1), s(2, 2), s(0, 1), s(0, 2), s(1, 2)};
}

inline Eigen::Matrix3d matrix_of(const SymmetricTensor& c) {
  return Eigen::Matrix3d{{c[0], c[3], c[4]}, {c[3], c[1], c[5]}, {c[4], c[5], c[2]}};
}

inline Eigen::Matrix3d traceless_symmetric(const Eigen::Matrix3d& tensor) {
  return (tensor + tensor.transpose()) / 2 - tensor.trace() / 3 * Eigen::Matrix3d::Identity();
}

/// Returns S of forces on the fluid at `positions`, without S_i.
inline Eigen::Matrix3d dipole_of_forces(const BeadVectors& positions, const BeadVectors& forces) {
  const Vec3 mean = positions.rowwise().mean();
  return traceless_symmetric((positions.colwise() - mean) * forces.transpose());
}

/// Returns the dipole with the tensor S in the frame of the orientation, whose first axis is e.
inline ForceDipole dipole_in_frame(const Eigen::Matrix3d& s) {
  return {.axial = 1.5 * s(0, 0), .tensor = components_of(s)};
}

/// Returns the dipole of forces on a line along the axis with the strength p = sum_i (x_i - x_m) F_i.
inline ForceDipole dipole_of_line(double p) {
  return dipole_in_frame(traceless_symmetric(p * Vec3::UnitX() * Vec3::UnitX().transpose()));
}

}  // namespace beadswim
