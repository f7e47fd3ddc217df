#include "beadswim/compare/cycle_statistics.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "beadswim/core/error.hpp"
#include "beadswim/core/setting.hpp"
#include "beadswim/swimmers/turning_frame.hpp"

namespace beadswim {
namespace {

using Samples = std::span<const SwimmerSample>;

/// Largest relative deviation of the sampled time span from one period. Sample times are sums of time steps
/// and therefore contain roundoff.
constexpr double period_tolerance = 1e-9;

void require_one_cycle(int index, Samples samples, double period) {
  const auto fail = [index](const std::string& what) {
    throw InputError(fmt::format("statistics of cycle {}", index), what);
  };
  if (samples.size() < 4) {
    fail(
        fmt::format("the cycle has {} samples, but needs at least 4, including both ends of the period; "
                    "use more {}",
                    samples.size(), Setting::frames_per_cycle));
  }
  const auto not_later = [](const SwimmerSample& a, const SwimmerSample& b) { return !(a.time < b.time); };
  if (std::adjacent_find(samples.begin(), samples.end(), not_later) != samples.end()) {
    fail("the times of the samples do not increase; the record is damaged, run again");
  }
  const double span = samples.back().time - samples.front().time;
  if (!(std::abs(span - period) <= period_tolerance * period)) {
    fail(fmt::format("the samples span a time of {}, not one period of {}; the record is damaged, run again",
                     span, period));
  }
}

/// Returns the time average of value(sample) over the period T = `period`, (1/T) int_0^T value(sample) dt, by
/// the trapezoidal rule.
template <typename Value>
Vec3 time_average(Samples samples, double period, Value value) {
  Vec3 integral = Vec3::Zero();
  for (std::size_t i = 1; i < samples.size(); ++i) {
    const double step = samples[i].time - samples[i - 1].time;
    integral += 0.5 * step * (value(samples[i - 1]) + value(samples[i]));
  }
  return integral / period;
}

Vec3 mean_bead_position(const SwimmerSample& sample) {
  Vec3 sum = sample.bead_positions.front();
  for (std::size_t b = 1; b < sample.bead_positions.size(); ++b) sum += sample.bead_positions[b];
  return sum / static_cast<double>(sample.bead_positions.size());
}

Eigen::Matrix3d orientation_of(const SwimmerSample& sample, const SwimmerType& type,
                               const Eigen::Matrix3d& near) {
  return fitted_orientation(type, columns_of_beads(sample.bead_positions), near);
}

/// Returns the part of the cycle until a sample, from 0 to 1.
double phase(const SwimmerSample& sample, Samples samples, double period) {
  return (sample.time - samples.front().time) / period;
}

/// Returns the displacement D (turning_frame.hpp) [length]. `turn`: Omega T.
Vec3 displacement(Samples samples, double period, const Vec3& turn, const BackgroundFlow& flow,
                  const Vec3& mean_flow) {
  std::vector<double> phases;
  std::vector<Vec3> places;
  for (const SwimmerSample& sample : samples) {
    phases.push_back(phase(sample, samples, period));
    places.push_back(mean_bead_position(sample));
  }
  const Vec3 carrying = mean_flow + flow.at(time_average(samples, period, mean_bead_position));
  return displacement_in_cycle(phases, places, turn, period * carrying);
}

/// Returns the rotation vector Omega T (turning_frame.hpp) between orientations at the ends of the cycle.
Vec3 rotation_vector(Samples samples, const SwimmerType& type, const Eigen::Matrix3d& start,
                     const Eigen::Matrix3d& end) {
  std::vector<Eigen::Matrix3d> parts;
  Eigen::Matrix3d before = start;
  for (const SwimmerSample& sample : samples.subspan(1)) {
    const Eigen::Matrix3d now = orientation_of(sample, type, before);
    parts.emplace_back(now * before.transpose());
    before = now;
  }
  return rotation_in_cycle(end * start.transpose(), parts);
}

}  // namespace

StrokeFit fit_cycle(Samples samples, double period,
                    const std::function<double(const SwimmerSample&)>& length) {
  std::vector<double> times, lengths;
  for (const SwimmerSample& sample : samples.first(samples.size() - 1)) {
    times.push_back(sample.time);
    lengths.push_back(length(sample));
  }
  return fit_stroke(times, lengths, 2 * std::numbers::pi / period);
}

Vec3 bond_vector(const SwimmerSample& sample, const Bond& bond) {
  return sample.bead_positions[bond.beads[1]] - sample.bead_positions[bond.beads[0]];
}

BeadVectors mean_shape(Samples samples, const SwimmerType& type, const Eigen::Matrix3d& initial_orientation) {
  const auto cycle = samples.first(samples.size() - 1);
  BeadVectors mean = BeadVectors::Zero(3, std::ssize(type.beads));
  Eigen::Matrix3d orientation = initial_orientation;
  for (const SwimmerSample& sample : cycle) {
    orientation = orientation_of(sample, type, orientation);
    const BeadVectors beads = columns_of_beads(sample.bead_positions);
    mean += orientation.transpose() * (beads.colwise() - Vec3(beads.rowwise().mean()));
  }
  return mean / static_cast<double>(cycle.size());
}

// The trapezoidal rule takes the frame of a part that is known as an integral at both ends of an interval.
ForceDipole mean_dipole(Samples samples, const SwimmerType& type,
                        const Eigen::Matrix3d& initial_orientation) {
  Eigen::Matrix3d before = orientation_of(samples.front(), type, initial_orientation);
  Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
  for (std::size_t i = 1; i < samples.size(); ++i) {
    const SwimmerSample &first = samples[i - 1], &last = samples[i];
    const Eigen::Matrix3d now = orientation_of(last, type, before);
    const double time = last.time - first.time;
    const Eigen::Matrix3d gained = matrix_of(last.dipole.integral) - matrix_of(first.dipole.integral);
    const auto in_frame = [&](const Eigen::Matrix3d& frame, const SwimmerSample& end) -> Eigen::Matrix3d {
      return frame.transpose() * (time * matrix_of(end.dipole.present) + gained) * frame;
    };
    sum += (in_frame(before, first) + in_frame(now, last)) / 2;
    before = now;
  }
  return dipole_in_frame(sum / (samples.back().time - samples.front().time));
}

CycleStatistics cycle_statistics(int index, Samples samples, const SwimmerType& type,
                                 const Eigen::Matrix3d& initial_orientation, const BackgroundFlow& flow) {
  const double period = type.driving.period;
  require_one_cycle(index, samples, period);
  CycleStatistics cycle;
  cycle.index = index;
  cycle.mean_flow = time_average(samples, period, [](const SwimmerSample& s) { return s.mean_flow; });
  const Eigen::Matrix3d start = orientation_of(samples.front(), type, initial_orientation);
  const Eigen::Matrix3d end = orientation_of(samples.back(), type, start);
  const Eigen::Quaterniond q(end);
  cycle.orientation = {q.w(), q.x(), q.y(), q.z()};
  const Vec3 rotation = rotation_vector(samples, type, start, end);
  cycle.angular_velocity = rotation / period;

  const Vec3 turn = drives_turn_with_swimmer(type.driving) ? rotation : Vec3(Vec3::Zero());
  cycle.velocity = displacement(samples, period, turn, flow, cycle.mean_flow) / period;
  const auto axis_at_start = [&](const SwimmerSample& s) -> Vec3 {
    return rotation_by(-phase(s, samples, period) * turn) *
           axis_of(type, s.bead_positions, initial_orientation);
  };
  cycle.axis = rotation_by(turn / 2) * time_average(samples, period, axis_at_start).normalized();
  cycle.speed_along_axis = cycle.velocity.dot(cycle.axis);
  for (const Bond& bond : type.bonds) {
    const StrokeFit fit =
        fit_cycle(samples, period, [&](const SwimmerSample& s) { return bond_vector(s, bond).norm(); });
    cycle.arm_amplitudes.push_back(fit.amplitude);
    cycle.arm_phases.push_back(fit.phase);
    cycle.arm_means.push_back(fit.mean);
  }
  return cycle;
}

Vec3 vector_relative_to_fluid(const CycleStatistics& cycle, const std::optional<Box>& box) {
  Vec3 relative = cycle.velocity;
  for (int axis = 0; axis < 3 && box; ++axis) {
    if (box->is_periodic(axis)) relative[axis] -= cycle.mean_flow[axis];
  }
  return relative;
}

double velocity_relative_to_fluid(const CycleStatistics& cycle, const std::optional<Box>& box) {
  return vector_relative_to_fluid(cycle, box).dot(cycle.axis);
}

}  // namespace beadswim
