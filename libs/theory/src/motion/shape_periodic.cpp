#include <Eigen/Geometry>
#include <algorithm>
#include <limits>

#include "beadswim/core/dense_systems.hpp"
#include "beadswim/core/error.hpp"
#include "beadswim/core/trigonometric_nodes.hpp"
#include "beadswim/swimmers/swimmer_forces.hpp"
#include "beadswim/swimmers/turning_frame.hpp"
#include "beadswim/theory/shaped_swimmer.hpp"
#include "shape_cycle.hpp"
#include "shape_flow.hpp"

namespace beadswim {
namespace {

/// Anderson's acceleration of a fixed-point iteration x <- g(x). The next x is a combination of the last
/// values of g that makes the change g - x smallest. Walker and Ni, SIAM J. Numer. Anal. 49 (2011) 1715.
class AndersonMixing {
 public:
  /// Returns the next x. mapped: g(x).
  Eigen::VectorXd next(const Eigen::VectorXd& x, const Eigen::VectorXd& mapped) {
    const Eigen::VectorXd change = mapped - x;
    if (steps_ > 0) {
      const Eigen::Index column = (steps_ - 1) % depth;
      if (changes_.cols() <= column) {
        changes_.conservativeResize(x.size(), column + 1);
        images_.conservativeResize(x.size(), column + 1);
      }
      changes_.col(column) = change - last_change_;
      images_.col(column) = mapped - last_mapped_;
    }
    last_change_ = change;
    last_mapped_ = mapped;
    if (steps_++ == 0) return mapped;
    return mapped - images_ * least_squares(changes_, change);
  }

 private:
  static constexpr Eigen::Index depth = 5;
  Eigen::Index steps_ = 0;
  Eigen::MatrixXd changes_, images_;  // differences of successive changes and values of g
  Eigen::VectorXd last_change_, last_mapped_;
};

/// Returns true if the motion does not depend on the orientation in the box.
bool is_free_to_turn(const ShapedSwimmer& swimmer) {
  return !swimmer.is_held() && drives_turn_with_swimmer(swimmer.type.driving);
}

/// Returns true if the shape repeats only in a frame that turns.
bool has_turning_frame(const ShapedSwimmer& swimmer) {
  return swimmer.is_held() || is_free_to_turn(swimmer);
}

Eigen::Matrix3d orientation_of(const ShapedSwimmer& swimmer, const BeadVectors& beads) {
  return fitted_orientation(swimmer.type, beads, swimmer.orientation);
}

/// Returns the rotation from one time to another. For a swimmer near a wall, this is the change of the fitted
/// orientation: its beads are nearly in line, so the rotation about that line is undetermined.
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
std::optional<ShapeCycle> periodic_cycle(const ShapedSwimmer& swimmer, const ShapeMobility& mobility,
                                         BeadVectors start, int steps) {
  constexpr int max_cycles = 200;
  constexpr double periodic = 1e-11;  // change of the shape in a cycle, divided by the size
  // Fast transients end in the first cycles. Afterwards, an extrapolation that does not help is given up, so
  // that the motion stays on its way to the state that it would reach by itself.
  constexpr int settling = 4;
  constexpr double growth = 2;
  AndersonMixing mixing;
  // Ratio of the changes in successive cycles, which multiply the remaining change by 1/(1 - contraction).
  constexpr double slowest = 0.9;
  double contraction = 0.5, last = 0;
  double smallest = std::numeric_limits<double>::infinity();
  for (int cycle = 0; cycle < max_cycles; ++cycle) {
    start = centred(start);
    if (swimmer.is_held()) start = swimmer.orientation * orientation_of(swimmer, start).transpose() * start;
    std::optional<ShapeCycle> motion = integrate_cycle(swimmer, mobility, start, steps);
    if (!motion) return std::nullopt;
    const BeadVectors end = moved_back(swimmer, *motion);
    const double size = start.cwiseAbs().maxCoeff() + swimmer.type.beads[0].radius;
    const double change = (end - start).cwiseAbs().maxCoeff();
    if (cycle > 0 && cycle < settling) contraction = std::clamp(change / last, contraction, slowest);
    last = change;
    if (change <= periodic * size) {
      motion->error += change / (1 - contraction);
      return motion;
    }
    if (cycle < settling || change > growth * smallest) {
      mixing = {};
      start = end;
    } else {
      start = as_beads(mixing.next(as_components(start), as_components(end)));
    }
    smallest = std::min(smallest, change);
  }
  throw InputError(
      "stroke",
      "the motion does not become periodic within {} cycles: drives along directions of the box turn the "
      "swimmer, or its springs are too soft; use the driving frame \"{}\", or stiffer springs",
      max_cycles, to_text(DrivingFrame::body));
}

/// Returns the rotation vector Omega T (swimmers/turning_frame.hpp) [radian].
Vec3 rotation_vector(const ShapedSwimmer& swimmer, const ShapeCycle& cycle) {
  std::vector<Eigen::Matrix3d> parts;
  for (std::size_t s = 0; s + 1 < cycle.beads.size(); ++s)
    parts.push_back(rotation_between(swimmer, cycle.beads[s], cycle.beads[s + 1]));
  return rotation_in_cycle(rotation_between(swimmer, cycle.beads.front(), cycle.beads.back()), parts);
}

/// Returns the displacement D relative to the background flow, in the orientation of the swimmer in the
/// middle of the cycle (swimmers/turning_frame.hpp) [length]. `carried`: displacement by the flow.
Vec3 own_displacement(const ShapedSwimmer& swimmer, const ShapeCycle& cycle, const Vec3& rotation,
                      const Vec3& carried) {
  const Vec3 turn = drives_turn_with_swimmer(swimmer.type.driving) ? rotation : Vec3(Vec3::Zero());
  std::vector<double> phases;
  std::vector<Vec3> places;
  for (std::size_t s = 0; s < cycle.beads.size(); ++s) {
    phases.push_back(static_cast<double>(s) / static_cast<double>(cycle.beads.size() - 1));
    places.emplace_back(cycle.beads[s].rowwise().mean());
  }
  return rotation_by(-turn / 2) * (displacement_in_cycle(phases, places, turn, carried) - carried);
}

ShapeMotion motion_of(const ShapedSwimmer& swimmer, const ShapeMobility& mobility, const ShapeCycle& cycle) {
  const SwimmerType& type = swimmer.type;
  const int steps = static_cast<int>(cycle.beads.size()) - 1;
  const double period = type.driving.period;
  const Vec3 rotation = has_turning_frame(swimmer) ? rotation_vector(swimmer, cycle) : Vec3(Vec3::Zero());
  ShapeMotion motion;
  motion.samples = steps;
  motion.mean_shape = BeadVectors::Zero(3, std::ssize(type.beads));
  Eigen::MatrixXd lengths(std::ssize(type.bonds), steps);
  const ShapeFlow flow(swimmer, mobility);
  Eigen::Matrix3d dipole = Eigen::Matrix3d::Zero();
  for (int s = 0; s < steps; ++s) {
    const double phase = static_cast<double>(s) / steps, time = phase * period;
    const BeadVectors& beads = cycle.beads[s];
    motion.mean_shape += rotation_by(-phase * rotation) * centred(beads) / steps;
    motion.power += power_of_drives(type, time, beads, cycle.velocities[s], swimmer.orientation) / steps;
    const Eigen::VectorXd damping = flow.damping(beads) * as_components(cycle.velocities[s]);
    dipole += dipole_of_beads(swimmer, mobility, beads, as_beads(flow.forces(beads, time) - damping)) / steps;
    motion.smallest_gap = std::min(motion.smallest_gap, smallest_gap(swimmer, beads));
    lengths.col(s) = bond_lengths(type, beads);
  }
  Eigen::VectorXcd amplitudes(lengths.rows());
  for (Eigen::Index k = 0; k < lengths.rows(); ++k) {
    motion.arm_changes.push_back(lengths.row(k).mean() - type.bonds[k].rest_length);
    amplitudes[k] = harmonic_amplitude(lengths.row(k), 1);
  }
  motion.stroke = stroke_of(amplitudes);
  motion.dipole = dipole_in_frame(dipole);
  // A swimmer that is free to turn is turned to the orientation of the layout. One that its drives turn keeps
  // its own.
  const Eigen::Matrix3d fit = orientation_of(swimmer, motion.mean_shape);
  const Eigen::Matrix3d turn = swimmer.orientation * fit.transpose();
  const bool free = is_free_to_turn(swimmer);
  motion.axis = swimmer.orientation.col(0);
  if (!has_turning_frame(swimmer)) {
    motion.turn = Eigen::AngleAxisd(turn).angle();
    motion.axis = fit.col(0);
  }
  const Eigen::Matrix3d to_box = free ? turn : Eigen::Matrix3d(Eigen::Matrix3d::Identity());
  motion.mean_shape = to_box * motion.mean_shape;
  const Vec3 carrying = swimmer.flow.at(swimmer.place);
  motion.velocity_vector =
      carrying + to_box * own_displacement(swimmer, cycle, rotation, period * carrying) / period;
  motion.velocity = motion.velocity_vector.dot(motion.axis);
  motion.angular_velocity = to_box * rotation / period;
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

ShapeMotion periodic_motion(const ShapedSwimmer& swimmer, const ShapeMobility& mobility) {
  const int multiple = highest_multiple(swimmer.type.driving);
  const int first = 32 * multiple, finest = 1024 * multiple;
  constexpr double resolved = 1e-7, roundoff = 1e-10;
  BeadVectors start = first_guess(swimmer);
  std::optional<ShapeMotion> motion;
  const auto lacks_error = [&] { return motion && !std::isfinite(motion->numerical_error); };
  for (int steps = first; steps <= finest || (steps == 2 * finest && lacks_error()); steps *= 2) {
    const std::optional<ShapeCycle> cycle = periodic_cycle(swimmer, mobility, start, steps);
    if (!cycle) continue;
    const std::optional<ShapeMotion> coarse = motion;
    motion = motion_of(swimmer, mobility, *cycle);
    start = cycle->beads.front();
    if (!coarse) continue;
    const double reach = motion->mean_shape.cwiseAbs().maxCoeff(), speed = largest_speed(*cycle);
    const auto is_resolved = [&](double difference, double size) {
      return difference <= std::max(resolved * size, roundoff * speed);
    };
    const double change = (motion->velocity_vector - coarse->velocity_vector).norm();
    motion->numerical_error = change + cycle->error / swimmer.type.driving.period;
    const Vec3 turning = motion->angular_velocity - coarse->angular_velocity;
    motion->is_resolved = is_resolved(change, motion->velocity_vector.norm()) &&
                          is_resolved(reach * turning.norm(), reach * motion->angular_velocity.norm());
    if (motion->is_resolved) break;
  }
  if (motion) return *motion;
  throw InputError(
      "stroke",
      "no periodic motion was found: the equations of a time step have no solution near the last "
      "positions; use weaker drives or stiffer springs");
}

}  // namespace beadswim
