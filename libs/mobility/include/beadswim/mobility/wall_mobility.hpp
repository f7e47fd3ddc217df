#pragma once

#include <Eigen/Core>
#include <span>

#include "beadswim/core/box.hpp"

namespace beadswim {

/// Adds the change of the mobility by a plane no-slip wall to the mobility matrix of spheres, whose rows and
/// columns are the components x, y, z of sphere 1, then of sphere 2, and so on [time/mass]. The change is
/// that of the Rotne-Prager mobility of spheres of finite size, or of point forces where the radius is 0, at
/// any distance from one another.
///   radii      of the spheres [length]
///   positions  centres of the spheres, in the fluid, one column for each [length]
///   viscosity  dynamic [mass/(length time)]
void add_wall_mobility(const HalfSpace& half_space, std::span<const double> radii,
                       const Eigen::Matrix3Xd& positions, double viscosity, Eigen::MatrixXd& mobility);

}  // namespace beadswim
