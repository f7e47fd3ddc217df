#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "beadswim/core/background_flow.hpp"
#include "beadswim/core/box.hpp"
#include "beadswim/mobility/mobility_matrix.hpp"
#include "beadswim/swimmers/swimmer_shape.hpp"
#include "beadswim/theory/stroke.hpp"

// Motion of a swimmer of any shape, alone in open space, in a box or over a plane no-slip wall, without
// inertia of fluid and beads.
//
//   v = u(x) + mu(x) [F(x, t) - C(x) v],   dx/dt = v
//
//   x, v   positions [length] and velocities of the beads [length/time]
//   mu     mobility of the beads, with their images in the box or behind the wall [time/mass]
//   u      background flow [length/time]
//   F, C   forces of springs, angular springs and drives [force], and damping of the dashpots [mass/time]
//
// A periodic motion repeats in a frame that moves with the swimmer: the frame has a constant velocity V and a
// constant angular velocity Omega in its own axes. If drives act along directions of the box, the motion is
// periodic only if Omega is zero. The velocity of the swimmer is the displacement of this frame in a period
// T, D/T (swimmers/turning_frame.hpp): the component of V along Omega, and sin(h)/h times that across, with h
// = Omega T/2.
//
// Over a wall, in a box or in a flow with a gradient, a motion does not repeat, because place and orientation
// change. The motion is then that of a swimmer whose shape repeats if it is moved back to its place and
// orientation after each cycle.
//
// Page: docs/method/motion-of-shapes.md.

namespace beadswim {

/// A swimmer of any shape, in any coherent units.
struct ShapedSwimmer {
  SwimmerType type;
  Eigen::Matrix3d orientation;  ///< at the start, from the frame of the type to the box
  double viscosity = 0;         ///< eta, dynamic [mass/(length time)]
  Domain domain{};              ///< a box without flow
  BackgroundFlow flow{};
  /// Position of the swimmer where wall, box or flow make it matter [length]: mean position of the beads at
  /// time 0 for periodic_motion(), their mean position over a period for second_order_motion().
  Vec3 place = Vec3::Zero();

  /// Returns true if the motion depends on place and orientation.
  bool is_held() const { return domain.half_space || domain.box || !flow.velocity_gradient.isZero(0); }

  bool operator==(const ShapedSwimmer&) const = default;
};

/// Mobility of the beads of a swimmer, at positions relative to its place [length]. Vectors and matrices have
/// the components x, y, z of bead 1, then of bead 2, and so on.
struct ShapeMobility {
  std::function<Eigen::MatrixXd(const BeadVectors& beads)> matrix;  ///< mu [time/mass]
  /// mu F, velocities of the beads by forces on them [length/time].
  std::function<Eigen::VectorXd(const BeadVectors& beads, const Eigen::VectorXd& forces)> apply;
  /// mu by pairs in open space: an estimate where iterations need a derivative.
  std::function<Eigen::MatrixXd(const BeadVectors& beads)> estimate;
  /// Sum of the stresslets of the beads by forces on them [mass length^2/time^2]; empty: beads have none.
  std::function<Eigen::Matrix3d(const BeadVectors& beads, const BeadVectors& forces)> stresslets{};
  bool may_be_indefinite = false;  ///< the law gives matrices that are not positive definite for close beads
};

/// Returns the mobility by a pair law, also over a wall. `swimmer` must outlive the result.
ShapeMobility pair_mobility(const ShapedSwimmer& swimmer, PairTensorLaw law);

/// Returns the mobility with force moments up to `order` on each bead (mobility/force_moments.hpp), also over
/// a wall or in a box; order 0 is Rotne-Prager. Relative errors of products are below 1e-10. Products throw
/// SolverError if they do not converge. `swimmer` must outlive the result.
ShapeMobility moment_mobility(const ShapedSwimmer& swimmer, int order);

/// Motion of a swimmer of any shape.
struct ShapeMotion : PeriodicMotion {
  /// D/T, of the cycle in whose middle the swimmer has the orientation of the layout, in the box
  /// [length/time]
  Vec3 velocity_vector = Vec3::Zero();
  /// Axis along which `velocity` is the component of `velocity_vector`: that of the mean shape if drives turn
  /// the swimmer (`turn`), else that of the layout.
  Vec3 axis = Vec3::Zero();
  Vec3 angular_velocity = Vec3::Zero();  ///< Omega, in the box [radian/time]
  double power = 0;                      ///< mean power of the drives [mass length^2/time^3]
  BeadVectors mean_shape;                ///< mean positions of the beads in the moving frame [length]
  /// Estimated error of V at finite amplitude [length/time]; infinite if it is not known.
  double numerical_error = std::numeric_limits<double>::infinity();
  bool is_resolved = false;  ///< at finite amplitude: doubling the number of time steps changed V little
  /// Angle between the orientation of the mean shape and that at the start, if drives act along directions of
  /// the box and turn the swimmer until its motion is periodic [radian].
  double turn = 0;
};

/// Motion of a swimmer of any shape to first order in the drives.
struct FirstOrderMotion {
  Stroke stroke;  ///< of the bonds, at the frequency of the driving
  /// Largest speed of each bead by constant drives plus that by each harmonic of the drives [length/time]
  std::vector<double> bead_speeds;

  double largest_speed() const { return std::ranges::max(bead_speeds); }
};

/// Returns the beads where springs and angular springs, with their drives at time 0, exert no forces, near
/// the places at rest [length]. The mean position is the origin, and the orientation fits that of the
/// swimmer. Throws InputError if there are no such places.
BeadVectors relaxed_shape(const ShapedSwimmer& swimmer);

/// Returns the motion to first order in the drives, relative to the background flow: each harmonic causes
/// its linear response (linear_response.hpp) about the relaxed shape. Throws InputError if there is no
/// relaxed shape or if an angular spring is bent on it.
FirstOrderMotion first_order_motion(const ShapedSwimmer& swimmer, PairTensorLaw law);

/// Returns the reason why second_order_motion() does not treat the surroundings or the forces: a flow, or
/// constant forces over a wall; an empty text if it does.
std::string second_order_obstacle(const ShapedSwimmer& swimmer);

/// Returns the motion to second order in the drives, which all have the same small factor.
///
/// The velocities in the moving frame are expanded about the relaxed shape X: x = X + p, and
///
///   R(p, V, Omega) = dp/dt + V + Omega x (X + p) - mu (F - C dp/dt) = 0
///
/// First order: first_order_motion(). Second order: the mean of the quadratic part of R, evaluated by central
/// differences, is the drift u, which V, Omega and a mean change of the shape balance.
///
/// Throws InputError if the springs leave a deformation free, which then drifts, or with the reason of
/// second_order_obstacle().
ShapeMotion second_order_motion(const ShapedSwimmer& swimmer, const ShapeMobility& mobility);
inline ShapeMotion second_order_motion(const ShapedSwimmer& swimmer, PairTensorLaw law) {
  return second_order_motion(swimmer, pair_mobility(swimmer, law));
}

/// Returns the periodic motion at finite amplitude. The equations of motion are integrated by the method
/// Radau IIA of order 5 over one cycle after the other until the shape at the end of a cycle is that at its
/// beginning; Anderson's acceleration shortens the transient. Then the number of time steps is doubled, at
/// most to 1024 in the period of the highest harmonic, until V changes by less than 1e-7 of V or 1e-10 of the
/// speed of the fastest bead.
///
/// Throws InputError if the motion does not become periodic, or if beads touch.
ShapeMotion periodic_motion(const ShapedSwimmer& swimmer, const ShapeMobility& mobility);
inline ShapeMotion periodic_motion(const ShapedSwimmer& swimmer, PairTensorLaw law) {
  return periodic_motion(swimmer, pair_mobility(swimmer, law));
}

/// Returns the drag coefficient of a swimmer with the beads at `shape`, relative to its place, towed along
/// `axis` without rotation [mass/time].
double towing_drag(const BeadVectors& shape, const Vec3& axis, const ShapeMobility& mobility);

}  // namespace beadswim
