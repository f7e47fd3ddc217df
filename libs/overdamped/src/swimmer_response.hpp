#pragma once

#include <Eigen/Core>
#include <span>

#include "beadswim/swimmers/swimmer_forces.hpp"

// How the three beads of one swimmer answer to each other, nine by nine: rows and columns are x, y, z of
// beads 1, 2, 3.

namespace beadswim {

using Matrix9 = Eigen::Matrix<double, 9, 9>;
using Vector9 = Eigen::Matrix<double, 9, 1>;

inline Vector9 as_vector(std::span<const Vec3> beads) {
  return Eigen::Map<const Vector9>(beads[0].data());
}

/// Rotne-Prager mobility of the swimmer alone in open space.
Matrix9 own_mobility(const SwimmerType& type, const BeadVectors& positions, double viscosity);

/// Springs' and the angular spring's forces: what is stiff.
Vector9 own_forces(const SwimmerType& type, const BeadVectors& positions);

/// -dF/dx of these: of springs as it is; of the angular spring that of K_A |u_2 - u_1|^2/2 without curvature,
/// u_1 and u_2 the arms' directions, alike in all but strong bending.
Matrix9 own_stiffness(const SwimmerType& type, const BeadVectors& positions);

/// -dF/dv of the dashpots.
Matrix9 own_damping(const SwimmerType& type, const BeadVectors& positions);

}  // namespace beadswim
