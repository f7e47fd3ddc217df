#pragma once

#include <Eigen/Core>
#include <span>

#include "beadswim/core/vec3.hpp"
#include "beadswim/swimmers/swimmer_type.hpp"

// Rotation and displacement of a swimmer in a cycle, the period T of its driving. If the drives turn with the
// swimmer, its beads x satisfy
//
//   x(t + T) = R x(t) + s,      R = exp(Omega T)
//
// The displacement c(t + T) - c(t) of the mean bead position c depends on t, because c oscillates about the
// path of the swimmer. In a frame that turns with the constant angular velocity Omega this displacement is
// periodic. Its mean over the cycle that begins at t = 0,
//
//   D = 1/T int_0^T exp(-Omega t) [(R - 1) (c(t) - c(0)) + c(T) - c(0)] dt
//
// belongs to the orientation of the frame at the start of the cycle. If a cycle begins at another time, D
// turns with the frame but does not change otherwise. Page: docs/method/stroke-fit.md.

namespace beadswim {

/// Returns true if all drives turn with the swimmer.
bool drives_turn_with_swimmer(const Driving& driving);

/// Returns the rotation about a rotation vector by its length [radian].
Eigen::Matrix3d rotation_by(const Vec3& vector);

/// Returns the rotation vector Omega T of a cycle [radian]. Its angle may exceed half a turn.
///   whole  rotation R from the start to the end of the cycle
///   parts  rotations from each sample to the next one, each by less than half a turn
Vec3 rotation_in_cycle(const Eigen::Matrix3d& whole, std::span<const Eigen::Matrix3d> parts);

/// Returns the displacement D [length].
///   phases   t/T of each sample, from 0 to 1
///   places   c at these times [length]
///   turn     Omega T [radian]; zero if the drives do not turn with the swimmer: D is then c(T) - c(0)
///   carried  displacement in the cycle by a flow that does not turn; it is added to that of the swimmer
///            relative to this flow [length]
Vec3 displacement_in_cycle(std::span<const double> phases, std::span<const Vec3> places, const Vec3& turn,
                           const Vec3& carried);

}  // namespace beadswim
