#pragma once

#include <Eigen/Core>
#include <span>

#include "beadswim/swimmers/swimmer_forces.hpp"

// Mobility, stiffness and damping of the three beads of one swimmer, as 9 x 9 matrices. Rows and columns are
// the components x, y, z of beads 1, 2, 3.

namespace beadswim {

using Matrix9 = Eigen::Matrix<double, 9, 9>;
using Vector9 = Eigen::Matrix<double, 9, 1>;

inline Vector9 as_vector(std::span<const Vec3> beads) {
  return Eigen::Map<const Vector9>(beads[0].data());
}

/// Returns the Rotne-Prager mobility of a swimmer alone in open space [time/mass]. viscosity: dynamic
/// viscosity of the fluid [mass/(length time)].
Matrix9 own_mobility(const SwimmerType& type, const BeadVectors& positions, double viscosity);

/// Returns the forces on the beads of the springs (without dashpots) and of the angular spring.
Vector9 own_forces(const SwimmerType& type, const BeadVectors& positions);

/// Returns the stiffness -dF/dx of own_forces() [mass/time^2]. The contribution of the springs is exact. The
/// contribution of the angular spring uses the approximation U = K_A |u_2 - u_1|^2/2, where u_1 and u_2 are
/// the unit vectors along the arms. Second derivatives of u_1 and u_2 are neglected. The approximation
/// matters only for strong bending.
Matrix9 own_stiffness(const SwimmerType& type, const BeadVectors& positions);

/// Returns the damping -dF/dv of the dashpots [mass/time].
Matrix9 own_damping(const SwimmerType& type, const BeadVectors& positions);

}  // namespace beadswim
