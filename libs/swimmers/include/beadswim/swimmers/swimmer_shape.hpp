#pragma once

#include <Eigen/Geometry>
#include <span>
#include <vector>

#include "beadswim/core/vec3.hpp"
#include "beadswim/swimmers/swimmer_type.hpp"

// Orientations and bead positions of a swimmer. An orientation is the rotation matrix from the frame of the
// type to the frame of the box; its first column is the axis of the swimmer.

namespace beadswim {

/// Vectors of the beads of one swimmer, one column per bead. Needs no memory of the heap.
using BeadVectors = Eigen::Matrix<double, 3, Eigen::Dynamic, Eigen::ColMajor, 3, max_beads>;

inline BeadVectors zero_vectors(const SwimmerType& type) {
  return BeadVectors::Zero(3, std::ssize(type.beads));
}

/// Returns a list of vectors of the beads as columns.
inline BeadVectors columns_of_beads(std::span<const Vec3> beads) {
  return Eigen::Map<const Eigen::Matrix3Xd>(beads[0].data(), 3, std::ssize(beads));
}

/// Returns the shortest rotation of the x axis onto the unit vector `axis`. The first column is `axis`, bit
/// by bit. For the axis -x it is the rotation by pi about z.
Eigen::Matrix3d shortest_turn(const Vec3& axis);

/// Returns the shortest rotation of one direction onto another.
Eigen::Quaterniond shortest_turn(const Vec3& from, const Vec3& to);

/// Returns the centres of the beads at rest. origin: position of the origin of the type's frame. For beads on
/// the x axis of the type the result is origin + x axis, without further rounding.
std::vector<Vec3> rest_positions(const SwimmerType& type, const Vec3& origin,
                                 const Eigen::Matrix3d& orientation);

/// Return the distance of the centres of two beads at rest, and the distance at which they touch [length].
double distance_at_rest(const SwimmerType& type, int i, int j);
double contact_distance(const SwimmerType& type, int i, int j);

/// Returns true if all beads at rest are on the x axis of the type.
bool is_straight(const SwimmerType& type);

/// Distances from the origin of the type's frame along one of its axes, forwards and backwards [length].
struct Reach {
  double ahead = 0, behind = 0;

  double length() const { return ahead + behind; }
};

/// Return the distances along axis `a` of the type's frame to the outermost bead centres and surfaces at
/// rest; 0 on a side of the origin without any.
Reach reach_of_centres(const SwimmerType& type, int a);
Reach reach_of_surfaces(const SwimmerType& type, int a);

/// Returns the angle theta of an angular spring between beads at `positions`, in [0, pi] [radian].
double angle_between(const Angle& angle, std::span<const Vec3> positions);

/// Returns the angle of an angular spring between the beads at rest; exactly 0 for beads on the x axis in
/// this order.
double angle_at_rest(const SwimmerType& type, const Angle& angle);

/// Returns the orientation that fits the beads at rest best to `positions` after a translation, in the sense
/// of least squares, with equal weights (Kabsch, Acta Cryst. A 32 (1976) 922). Where the beads leave it open,
/// as the rotation of a straight swimmer about its axis, the result is as near as possible to `near`.
Eigen::Matrix3d fitted_orientation(const SwimmerType& type, const BeadVectors& positions,
                                   const Eigen::Matrix3d& near);

/// Returns the axis of a swimmer, a unit vector: along the line of the beads if they are on the x axis of the
/// type, from the bead with the smallest to that with the largest x; otherwise the first column of the fitted
/// orientation.
Vec3 axis_of(const SwimmerType& type, std::span<const Vec3> positions,
             const Eigen::Matrix3d& initial_orientation);

// Shapes on which springs and angular springs, with their drives, are in equilibrium. Page:
// docs/method/springs.md.

/// Returns true if drives change rest lengths or rest angles, and thereby prescribe a shape.
bool has_driven_shape(const Driving& driving);

struct RelaxedShape {
  BeadVectors beads;  ///< in the frame of the type, with mean position and orientation of those at rest
  bool is_converged = false;  ///< false: no equilibrium was found; `beads` have the smallest energy found
};

/// Returns the shape of smallest energy of springs and angular springs, with their drives at time 0, that is
/// reached from the beads at rest. Springs that fit together exert no forces on it. The beads move as little
/// as possible: deformations that no spring resists stay as they are, and each angle stays on its side.
RelaxedShape relaxed_shape(const SwimmerType& type);

/// Returns the type with its beads where they are at the start of a run: on the relaxed shape if the type has
/// a driven shape, otherwise at rest. A type whose beads are there within roundoff is returned unchanged.
SwimmerType at_start(SwimmerType type);

}  // namespace beadswim
