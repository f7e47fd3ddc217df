#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "beadswim/core/background_flow.hpp"
#include "beadswim/core/box.hpp"
#include "beadswim/mobility/mobility_matrix.hpp"
#include "beadswim/swimmers/swimmer_shape.hpp"
#include "beadswim/theory/stroke.hpp"

// Motion of a swimmer of any shape, alone in open space or over a plane no-slip wall, without inertia of
// fluid and beads.
//
//   v = u(x) + mu(x) [F(x, t) - C(x) v],   dx/dt = v
//
//   x, v   positions [length] and velocities of the beads [length/time]
//   mu     mobility of the beads by a pair law, with the images of the beads behind the wall [time/mass]
//   u      background flow [length/time]
//   F, C   forces of springs, angular springs and drives [force], and damping of the dashpots [mass/time]
//
// A periodic motion repeats in a frame that moves with the swimmer: the frame has a constant velocity V and a
// constant angular velocity Omega in its own axes. If drives act along directions of the box, the motion is
// periodic only if Omega is zero. The velocity of the swimmer is the displacement of this frame in a period
// T, D/T (swimmers/turning_frame.hpp): the component of V along Omega, and sin(h)/h times that across, with h
// = Omega T/2.
//
// Over a wall or in a flow with a gradient, a motion does not repeat, because place and orientation change.
// The motion is then that of a swimmer whose shape repeats if it is moved back to its place and orientation
// after each cycle.
//
// Page: docs/method/motion-of-shapes.md.

namespace beadswim {

/// A swimmer of any shape, in any coherent units.
struct ShapedSwimmer {
  SwimmerType type;
  Eigen::Matrix3d orientation;  ///< at the start, from the frame of the type to the box
  double viscosity = 0;         ///< eta, dynamic [mass/(length time)]
  std::optional<HalfSpace> half_space{};
  BackgroundFlow flow{};
  /// Mean position of the beads at time 0, where wall or flow make it matter [length].
  Vec3 place = Vec3::Zero();

  /// Returns true if the motion depends on place and orientation.
  bool is_held() const { return half_space || !flow.velocity_gradient.isZero(0); }

  bool operator==(const ShapedSwimmer&) const = default;
};

/// Motion of a swimmer of any shape.
struct ShapeMotion : PeriodicMotion {
  /// D/T, of the cycle in whose middle the swimmer has the orientation of the layout, in the box
  /// [length/time]
  Vec3 velocity_vector = Vec3::Zero();
  Vec3 angular_velocity = Vec3::Zero();  ///< Omega, in the box [radian/time]
  double power = 0;                      ///< mean power of the drives [mass length^2/time^3]
  BeadVectors mean_shape;                ///< mean positions of the beads in the moving frame [length]
  double numerical_error = 0;            ///< estimated, of V at finite amplitude [length/time]
  /// Angle between the orientation of the mean shape and that at the start, if drives act along directions of
  /// the box and turn the swimmer until its motion is periodic [radian].
  double turn = 0;
};

/// Returns the beads where springs and angular springs, with their drives at time 0, exert no forces, near
/// the places at rest [length]. The mean position is the origin, and the orientation fits that of the
/// swimmer. Throws InputError if there are no such places.
BeadVectors relaxed_shape(const ShapedSwimmer& swimmer);

/// Returns the motion to second order in the drives, which all have the same small factor.
///
/// The velocities in the moving frame are expanded about the relaxed shape X: x = X + p, and
///
///   R(p, V, Omega) = dp/dt + V + Omega x (X + p) - mu (F - C dp/dt) = 0
///
/// First order: each harmonic of the drives causes its linear response (linear_response.hpp). Second order:
/// the mean of the quadratic part of R, evaluated by central differences, is the drift u, which V, Omega and
/// a mean change of the shape balance.
///
/// Throws InputError if the springs leave a deformation free, which then drifts, in a flow, or under constant
/// forces over a wall.
ShapeMotion second_order_motion(const ShapedSwimmer& swimmer, PairTensorLaw law);

/// Returns the periodic motion at finite amplitude. The equations of motion are integrated by the method
/// Radau IIA of order 5 over one cycle after the other until the shape at the end of a cycle is that at its
/// beginning; Anderson's acceleration shortens the transient. Then the number of time steps is doubled until
/// V changes by less than 1e-7 of the speed of the beads.
///
/// Throws InputError if the motion does not become periodic, or if beads touch.
ShapeMotion periodic_motion(const ShapedSwimmer& swimmer, PairTensorLaw law);

/// Returns the drag coefficient of the swimmer with the beads at `shape`, relative to its place, towed
/// along `axis` without rotation [mass/time].
double towing_drag(const ShapedSwimmer& swimmer, const BeadVectors& shape, const Vec3& axis,
                   PairTensorLaw law);

}  // namespace beadswim
