#pragma once

#include <Eigen/Core>
#include <span>

#include "beadswim/swimmers/swimmer_forces.hpp"

// Forces of the springs of one swimmer, and their derivatives, as vectors and matrices. Rows and columns are the
// components x, y, z of bead 1, then of bead 2, and so on. Size: number of these components, 9 for three
// beads, where a size known to the compiler is faster, or Eigen::Dynamic.

namespace beadswim {

template <int Size>
using SwimmerMatrix = Eigen::Matrix<double, Size, Size>;
template <int Size>
using SwimmerVector = Eigen::Matrix<double, Size, 1>;

constexpr int size_of_three_beads = 9;

template <int Size>
auto as_vector(const BeadVectors& beads) {
  return Eigen::Map<const SwimmerVector<Size>>(beads.data(), beads.size());
}

/// Returns the forces on the beads of the springs (without dashpots) and of the angular springs at `time`.
template <int Size>
SwimmerVector<Size> own_forces(const SwimmerType& type, double time, const BeadVectors& positions);

/// Returns the stiffness -dF/dx of own_forces() [mass/time^2]. The contribution of the springs is exact. That
/// of an angular spring neglects second derivatives: of the unit vectors u_1 and u_2 along its sides, in U =
/// K_A |u_2 - u_1|^2/2, if its rest angle is 0; of the strain s of a hinge, in U = K_A |s|^2/2 (hinges.hpp);
/// otherwise of its angle theta, in U = K_A (theta - rest)^2/2.
/// This matters only far from the rest angle.
template <int Size>
SwimmerMatrix<Size> own_stiffness(const SwimmerType& type, double time, const BeadVectors& positions);

/// Returns the damping -dF/dv of the dashpots [mass/time].
template <int Size>
SwimmerMatrix<Size> own_damping(const SwimmerType& type, const BeadVectors& positions);

}  // namespace beadswim
