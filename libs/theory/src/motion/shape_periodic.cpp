#include <fmt/format.h>

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <numbers>

#include "anderson_mixing.hpp"
#include "beadswim/core/error.hpp"
#include "beadswim/core/trigonometric_nodes.hpp"
#include "beadswim/swimmers/swimmer_forces.hpp"
#include "beadswim/theory/shaped_swimmer.hpp"
#include "shape_cycle.hpp"
#include "shape_flow.hpp"

namespace beadswim {
namespace {

/// Returns true if the motion does not depend on the orientation in the box.
bool is_free_to_turn(const ShapedSwimmer& swimmer) {
  const Driving& driving = swimmer.type.driving;
  return !swimmer.is_held() && (driving.forces.empty() || driving.frame == DrivingFrame::body);
}

/// Returns true if the shape repeats only in a frame that turns.
bool has_turning_frame(const ShapedSwimmer& swimmer) {
  return swimmer.is_held() || is_free_to_turn(swimmer);
}

Eigen::Matrix3d orientation_of(const ShapedSwimmer& swimmer, const BeadVectors& beads) {
  return fitted_orientation(swimmer.type, beads, swimmer.orientation);
}

/// Returns the rotation from one time to another. Over a wall, which bends a swimmer slightly, it is that of
/// the fitted orientation, because a rotation about a line of beads is not defined.
Eigen::Matrix3d rotation_between(const ShapedSwimmer& swimmer, const BeadVectors& from,
                                 const BeadVectors& to) {
  if (!swimmer.is_held()) return best_rotation(from, to);
  return orientation_of(swimmer, to) * orientation_of(swimmer, from).transpose();
}

/// Returns the beads at the end of a cycle, moved back to those at its start: without the translation and
/// without the rotation of the frame.
BeadVectors moved_back(const ShapedSwimmer& swimmer, const ShapeCycle& cycle) {
  const BeadVectors end = centred(cycle.beads.back());
  if (!has_turning_frame(swimmer)) return end;
  return rotation_between(swimmer, cycle.beads.front(), end).transpose() * end;
}

/// Returns the cycle of the periodic motion, with its mean bead position at the origin at time 0. start:
/// guess of the beads at time 0. Returns nothing if the time steps are too long.
std::optional<ShapeCycle> periodic_cycle(const ShapedSwimmer& swimmer, PairTensorLaw law, BeadVectors start,
                                         int steps) {
  constexpr int max_cycles = 200;
  constexpr double periodic = 1e-11;  // change of the shape in a cycle, divided by the size
  // Fast transients end in the first cycles. Afterwards, an extrapolation that does not help is given up, so
  // that the motion stays on its way to the state that it would reach by itself.
  constexpr int settling = 4;
  constexpr double growth = 2;
  AndersonMixing mixing;
  double smallest = std::numeric_limits<double>::infinity();
  for (int cycle = 0; cycle < max_cycles; ++cycle) {
    start = centred(start);
    if (swimmer.is_held()) start = swimmer.orientation * orientation_of(swimmer, start).transpose() * start;
    const std::optional<ShapeCycle> motion = integrate_cycle(swimmer, law, start, steps);
    if (!motion) return std::nullopt;
    const BeadVectors end = moved_back(swimmer, *motion);
    const double size = start.cwiseAbs().maxCoeff() + swimmer.type.beads[0].radius;
    const double change = (end - start).cwiseAbs().maxCoeff();
    if (change <= periodic * size) return motion;
    if (cycle < settling || change > growth * smallest) {
      mixing = {};
      start = end;
    } else {
      start = as_beads(mixing.next(as_components(start), as_components(end)));
    }
    smallest = std::min(smallest, change);
  }
  throw InputError(
      "stroke", fmt::format("the motion does not become periodic within {} cycles: drives along directions "
                            "of the box turn the swimmer, or its springs are too soft; use the driving frame "
                            "\"{}\", or stiffer springs",
                            max_cycles, to_text(DrivingFrame::body)));
}

Vec3 rotation_vector(const Eigen::Matrix3d& rotation) {
  const Eigen::AngleAxisd turn(rotation);
  return turn.angle() * turn.axis();
}

/// Returns the rotation vector of the whole cycle; its angle may exceed half a turn.
Vec3 rotation_in(const ShapedSwimmer& swimmer, const ShapeCycle& cycle) {
  Vec3 sum = Vec3::Zero();
  for (std::size_t s = 0; s + 1 < cycle.beads.size(); ++s)
    sum += rotation_vector(rotation_between(swimmer, cycle.beads[s], cycle.beads[s + 1]));
  const Vec3 rest = rotation_vector(rotation_between(swimmer, cycle.beads.front(), cycle.beads.back()));
  const double angle = rest.norm();
  constexpr double roundoff = 1e-9;
  const Vec3 axis = angle > roundoff ? Vec3(rest / angle) : sum.stableNormalized();
  constexpr double whole = 2 * std::numbers::pi;
  return rest + whole * std::round((sum.dot(axis) - angle) / whole) * axis;
}

Eigen::Matrix3d rotation_by(const Vec3& vector) {
  const double angle = vector.norm();
  return angle > 0 ? Eigen::AngleAxisd(angle, vector / angle).toRotationMatrix()
                   : Eigen::Matrix3d(Eigen::Matrix3d::Identity());
}

/// Returns the integral of rotation_by(u vector) over u from 0 to 1.
Eigen::Matrix3d mean_rotation(const Vec3& vector) {
  Eigen::Matrix3d cross;
  cross << 0, -vector.z(), vector.y(), vector.z(), 0, -vector.x(), -vector.y(), vector.x(), 0;
  const double angle = vector.norm(), a2 = angle * angle;
  constexpr double small = 1e-3;  // below it, series are exact to roundoff
  const double first = angle < small ? 0.5 - a2 / 24 : (1 - std::cos(angle)) / a2;
  const double second = angle < small ? 1.0 / 6 - a2 / 120 : (angle - std::sin(angle)) / (a2 * angle);
  return Eigen::Matrix3d::Identity() + first * cross + second * cross * cross;
}

/// A frame that moves along a helix: rotation E(t) = exp(Omega t) and origin o(t) = o(0) + integral of E V.
/// In it the motion is periodic, and the mean over a period of the mean bead position is its origin.
struct MovingFrame {
  Vec3 velocity, angular_velocity;  ///< V, Omega at time 0
  Vec3 origin;                      ///< o(0)
};

/// Returns the moving frame. The mean bead position c satisfies
///
///   c(t) = o(t) + E(t) xi(t),   xi(T) = xi(0),   <xi> = 0
///
/// which are six linear equations for o(0) and V.
MovingFrame moving_frame(const ShapedSwimmer& swimmer, const ShapeCycle& cycle) {
  const double period = swimmer.type.driving.period;
  const int steps = static_cast<int>(cycle.beads.size()) - 1;
  Vec3 turn = Vec3::Zero();  // Omega T
  if (has_turning_frame(swimmer)) turn = rotation_in(swimmer, cycle);
  const auto centre = [&](int s) -> Vec3 { return cycle.beads[s].rowwise().mean(); };
  Eigen::Matrix<double, 6, 6> equations = Eigen::Matrix<double, 6, 6>::Zero();
  Eigen::Matrix<double, 6, 1> right = Eigen::Matrix<double, 6, 1>::Zero();
  const Eigen::Matrix3d whole = rotation_by(turn), unit = Eigen::Matrix3d::Identity();
  equations.topLeftCorner<3, 3>() = unit - whole;  // o(0)
  equations.topRightCorner<3, 3>() = period * mean_rotation(turn);
  right.head<3>() = centre(steps) - whole * centre(0);
  for (int s = 0; s < steps; ++s) {
    const double part = static_cast<double>(s) / steps;
    const Eigen::Matrix3d back = rotation_by(-part * turn);
    equations.bottomLeftCorner<3, 3>() += back / steps;
    equations.bottomRightCorner<3, 3>() += back * (part * period / steps) * mean_rotation(part * turn);
    right.tail<3>() += back * centre(s) / steps;
  }
  const Eigen::Matrix<double, 6, 1> solution = equations.partialPivLu().solve(right);
  return {.velocity = solution.tail<3>(), .angular_velocity = turn / period, .origin = solution.head<3>()};
}

PeriodicShapeMotion motion_of(const ShapedSwimmer& swimmer, const ShapeCycle& cycle) {
  const SwimmerType& type = swimmer.type;
  const int steps = static_cast<int>(cycle.beads.size()) - 1;
  const MovingFrame frame = moving_frame(swimmer, cycle);
  PeriodicShapeMotion motion;
  motion.steps = steps;
  motion.smallest_gap = std::numeric_limits<double>::infinity();
  motion.mean_shape = BeadVectors::Zero(3, std::ssize(type.beads));
  Eigen::MatrixXd lengths(std::ssize(type.bonds), steps);
  for (int s = 0; s < steps; ++s) {
    const double part = static_cast<double>(s) / steps, time = part * type.driving.period;
    const BeadVectors& beads = cycle.beads[s];
    motion.mean_shape += rotation_by(-time * frame.angular_velocity) * centred(beads) / steps;
    motion.power += power_of_drives(type, time, beads, cycle.velocities[s], swimmer.orientation) / steps;
    motion.smallest_gap = std::min(motion.smallest_gap, smallest_gap(swimmer, beads));
    lengths.col(s) = bond_lengths(type, beads);
  }
  std::vector<std::complex<double>> amplitudes;
  for (std::size_t k = 0; k < type.bonds.size(); ++k) {
    motion.bond_means.push_back(lengths.row(k).mean());
    amplitudes.push_back(harmonic_amplitude(lengths.row(k), 1));
  }
  motion.stroke = stroke_of(amplitudes);
  // Results are for the orientation of the layout; the motion was found in another one.
  const Eigen::Matrix3d fit = orientation_of(swimmer, motion.mean_shape);
  const Eigen::Matrix3d turn = swimmer.orientation * fit.transpose();
  const bool free = is_free_to_turn(swimmer);
  if (!has_turning_frame(swimmer)) motion.turn = Eigen::AngleAxisd(turn).angle();
  const Eigen::Matrix3d to_box = free ? turn : Eigen::Matrix3d(Eigen::Matrix3d::Identity());
  motion.mean_shape = to_box * motion.mean_shape;
  motion.velocity = to_box * frame.velocity;
  motion.angular_velocity = to_box * frame.angular_velocity;
  return motion;
}

/// Returns the largest speed of a bead in the cycle [length/time].
double largest_speed(const ShapeCycle& cycle) {
  double largest = 0;
  for (const BeadVectors& velocity : cycle.velocities)
    largest = std::max(largest, velocity.colwise().norm().maxCoeff());
  return largest;
}

/// Returns the shape that the driven lengths and angles prescribe at time 0; where springs work against one
/// another, the places at rest.
BeadVectors first_guess(const ShapedSwimmer& swimmer) {
  try {
    return relaxed_shape(swimmer);
  } catch (const InputError&) {
    return columns_of_beads(rest_positions(swimmer.type, Vec3::Zero(), swimmer.orientation));
  }
}

}  // namespace

PeriodicShapeMotion periodic_motion(const ShapedSwimmer& swimmer, PairTensorLaw law) {
  const int multiple = highest_multiple(swimmer.type.driving);
  const int first = 32 * multiple, finest = 1024 * multiple;
  constexpr double resolved = 1e-7, roundoff = 1e-10;
  BeadVectors start = first_guess(swimmer);
  std::optional<PeriodicShapeMotion> motion;
  for (int steps = first; steps <= finest; steps *= 2) {
    const std::optional<ShapeCycle> cycle = periodic_cycle(swimmer, law, start, steps);
    if (!cycle) continue;
    const std::optional<PeriodicShapeMotion> coarse = motion;
    motion = motion_of(swimmer, *cycle);
    start = cycle->beads.front();
    if (!coarse) continue;
    motion->numerical_error = (motion->velocity - coarse->velocity).norm();
    const double enough = std::max(resolved * motion->velocity.norm(), roundoff * largest_speed(*cycle));
    if (motion->numerical_error <= enough) break;
  }
  if (motion) return *motion;
  throw InputError(
      "stroke",
      "no periodic motion was found: the equations of a time step have no solution near the last "
      "positions; use weaker drives or stiffer springs");
}

}  // namespace beadswim
