#pragma once

#include <Eigen/Core>

#include "beadswim/swimmers/swimmer_shape.hpp"
#include "beadswim/swimmers/swimmer_type.hpp"

// Hinges: angular springs with a normal n_0 (Angle), which bend through straight to both sides. With the unit
// vectors u and w along the sides of a hinge, its bending vector kappa, its rest angle rest(t) and its
// stiffness K_A,
//
// clang-format off
//   kappa = theta u x w/|u x w|,      sin(theta) = |u x w|,   cos(theta) = u . w
//   U     = K_A |s|^2/2,              s = kappa - rest n,     n = R n_0
//   F_b   = -K_A B_b^T s,             B_b = ds/dx_b
//   R     = the rotation that fits X(t) best to the beads x (Kabsch, Acta Cryst. A 32 (1976) 922)
//   dn    = R (omega x n_0),          (tr(H) 1 - H) omega = sum_b X_b x R^T dx_b,   H = R^T sum_b x_b X_b^T
// clang-format on
//
// X(t) is the shape at time t with all hinges at their rest angles. A planar shape and its mirror image
// differ by half a turn alone, so that no orientation fitted to a fixed shape tells a bend from the opposite
// one. In the plane across n, U = K_A (theta - rest)^2/2 with the angle theta from -pi to pi about n. U does
// not change if the whole swimmer moves or turns: the forces have no sum and no torque. Page:
// docs/method/springs.md.

namespace beadswim {

/// Returns true if the type has an angular spring with a normal.
bool has_hinges(const SwimmerType& type);

/// Returns true if bonds join the third bead of an angle to its first only through the second, so that the
/// angle can change without a change of other angles.
bool separates_beads(const SwimmerType& type, const Angle& angle);

/// Returns the type with its beads at X(t): the beads on both sides of each hinge are turned about its second
/// bead, each by half the angle, and the mean bead position stays as it is. A type without hinges is returned
/// unchanged.
SwimmerType at_rest_angles(SwimmerType type, double time);

/// Orientation of a swimmer with hinges, R, and what its derivative needs.
struct HingeFit {
  Eigen::Matrix3d rotation;  ///< R
  BeadVectors shape;         ///< X(t), relative to its mean [length]
  Eigen::Matrix3d turns;     ///< (tr(H) 1 - H)^-1 [1/length^2]
};
HingeFit fit_hinges(const SwimmerType& type, double time, const BeadVectors& positions);

/// Strain s of a hinge, and its derivative B by the bead positions, three columns per bead [1/length].
struct HingeStrain {
  Vec3 strain;
  Eigen::Matrix<double, 3, Eigen::Dynamic, Eigen::ColMajor, 3, 3 * max_beads> derivative;
};
HingeStrain hinge_strain(const HingeFit& fit, const Angle& hinge, double rest, const BeadVectors& positions);

/// Returns the angle of an angular spring at `time`: theta in [0, pi], or n . kappa for a hinge [radian].
double angle_of(const SwimmerType& type, const Angle& angle, double time, const BeadVectors& positions);

/// Returns theta - rest, or |s| for a hinge: 0 where the angular spring exerts no force [radian].
double bending_of(const SwimmerType& type, std::size_t angle, double time, const BeadVectors& positions);

/// Returns the root mean square distance of the beads from the line that fits them best, across it in the
/// plane that fits them best [length].
double width_of(const BeadVectors& beads);

}  // namespace beadswim
