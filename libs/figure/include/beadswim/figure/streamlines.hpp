#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <functional>
#include <vector>

namespace beadswim {

/// A place in a plane, or a vector in it.
using PlanePoint = Eigen::Vector2d;

/// Velocity in a plane. It must be defined at places outside of the region that are near to it. Streamlines
/// end where it is zero.
using PlaneVelocity = std::function<PlanePoint(const PlanePoint&)>;

/// Points of a line, in the direction of the flow.
using Streamline = std::vector<PlanePoint>;

/// Returns streamlines that fill a region evenly, by the method of Jobard & Lefer (Visualization in
/// Scientific Computing '97, 43-55): each line begins at least about `distance` away from all earlier lines,
/// and ends where it is nearer than `distance` / 2 to one of them, outside of the region (by less than one
/// step), or after one turn. A line that returns to its first point is closed: it ends in the same point.
/// Steps are of the classical Runge-Kutta method and have the length `distance` / 10.
std::vector<Streamline> streamlines(const PlaneVelocity& velocity, const Eigen::AlignedBox2d& region,
                                    double distance);

}  // namespace beadswim
