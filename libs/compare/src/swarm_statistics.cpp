#include "beadswim/compare/swarm_statistics.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <complex>
#include <vector>

#include "beadswim/compare/nearest_neighbours.hpp"

namespace beadswim {
namespace {

using Members = std::span<const SwarmMember>;
using Cycles = std::vector<const CycleStatistics*>;

/// Returns the mean <x> of at least one value as x_1 + <x - x_1>. This form is exact if all values are equal,
/// and accurate if they are nearly equal.
double mean_of(std::span<const double> values) {
  double sum = 0;
  for (const double x : values) sum += x - values.front();
  return values.front() + sum / static_cast<double>(values.size());
}

/// Returns mean, standard deviation, smallest and largest value of at least one value. The deviation is
/// evaluated in a second pass, because the formula <x^2> - <x>^2 (<>: mean) would lose significance for small
/// deviations.
Spread spread_of(std::span<const double> values) {
  const double mean = mean_of(values);
  double squares = 0;
  for (const double x : values) squares += (x - mean) * (x - mean);
  const auto [smallest, largest] = std::minmax_element(values.begin(), values.end());
  return {.mean = mean,
          .deviation = std::sqrt(squares / static_cast<double>(values.size())),
          .smallest = *smallest,
          .largest = *largest};
}

/// Returns the spread of value(member) over a range.
template <typename Range, typename Value>
Spread spread_over(const Range& range, Value value) {
  std::vector<double> values;
  values.reserve(range.size());
  for (const auto& member : range) values.push_back(value(member));
  return spread_of(values);
}

/// Returns the order parameter of Kuramoto (1984), |<exp(i delta)>|, where delta is the phase of one arm.
double phase_order(const Cycles& cycles, std::size_t arm) {
  std::complex<double> sum = 0;
  for (const CycleStatistics* cycle : cycles) sum += std::polar(1.0, cycle->arm_phases[arm]);
  return std::abs(sum) / static_cast<double>(cycles.size());
}

SwarmSwimming swimming_of(const Cycles& cycles) {
  SwarmSwimming swimming;
  swimming.swimmers = static_cast<int>(cycles.size());
  for (int axis = 0; axis < 3; ++axis) {
    const Spread velocity = spread_over(cycles, [=](auto* cycle) { return cycle->velocity[axis]; });
    swimming.velocity[axis] = velocity.mean;
    swimming.velocity_deviation[axis] = velocity.deviation;
    swimming.mean_flow[axis] = spread_over(cycles, [=](auto* cycle) { return cycle->mean_flow[axis]; }).mean;
  }
  swimming.speed_along_axis = spread_over(cycles, [](auto* cycle) { return cycle->speed_along_axis; });
  for (std::size_t arm = 0;; ++arm) {
    Cycles with_arm;
    std::ranges::copy_if(cycles, std::back_inserter(with_arm),
                         [=](auto* cycle) { return arm < cycle->arm_means.size(); });
    if (with_arm.empty()) break;
    swimming.arm_amplitudes.push_back(spread_over(with_arm, [=](auto* c) { return c->arm_amplitudes[arm]; }));
    swimming.arm_means.push_back(spread_over(with_arm, [=](auto* c) { return c->arm_means[arm]; }));
    swimming.arm_phase_order.push_back(phase_order(with_arm, arm));
  }
  if (std::ranges::all_of(cycles, [](auto* cycle) { return cycle->power.has_value(); }))
    swimming.power = spread_over(cycles, [](auto* cycle) { return *cycle->power; });
  return swimming;
}

Cycles last_cycles(Members members) {
  Cycles cycles;
  for (const SwarmMember& member : members) {
    if (member.last_cycle) cycles.push_back(&*member.last_cycle);
  }
  return cycles;
}

/// Returns Q = <(3 a a - 1)/2>, the mean over all swimmers. a: axis of a swimmer; a a: dyadic product.
Eigen::Matrix3d nematic_tensor(Members members) {
  Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
  for (const SwarmMember& member : members) sum += member.axis * member.axis.transpose();
  return 1.5 * sum / static_cast<double>(members.size()) - 0.5 * Eigen::Matrix3d::Identity();
}

Vec3 with_largest_component_positive(const Vec3& v) {
  int axis = 0;
  v.cwiseAbs().maxCoeff(&axis);
  return v[axis] < 0 ? Vec3(-v) : v;
}

/// Returns the angle between two vectors, in [0, pi] [rad]. The arc cosine of the scalar product would not
/// resolve angles below 1e-8.
double angle_between(const Vec3& a, const Vec3& b) {
  return std::atan2(a.cross(b).norm(), a.dot(b));
}

std::optional<Spread> nearest_neighbours_of(Members members, const std::optional<Box>& box) {
  std::vector<Vec3> centres;
  centres.reserve(members.size());
  for (const SwarmMember& member : members) centres.push_back(member.centre);
  const std::vector<double> distances = nearest_neighbour_distances(centres, box);
  if (std::isinf(distances.front())) return std::nullopt;
  return spread_of(distances);
}

}  // namespace

SwarmStatistics swarm_statistics(int index, Members members, const std::optional<Box>& box) {
  SwarmStatistics swarm;
  swarm.index = index;
  if (members.empty()) return swarm;
  swarm.swimmers = static_cast<int>(members.size());
  if (const Cycles cycles = last_cycles(members); !cycles.empty()) swarm.swimming = swimming_of(cycles);

  for (int axis = 0; axis < 3; ++axis)
    swarm.mean_axis[axis] = spread_over(members, [=](const SwarmMember& m) { return m.axis[axis]; }).mean;
  swarm.polar_order = swarm.mean_axis.norm();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> nematic(nematic_tensor(members));
  swarm.nematic_order = nematic.eigenvalues()[2];  // the largest: eigenvalues are in increasing order
  swarm.director = with_largest_component_positive(nematic.eigenvectors().col(2));

  swarm.rotation =
      spread_over(members, [](const SwarmMember& m) { return angle_between(m.axis, m.initial_axis); });
  swarm.nearest_neighbour = nearest_neighbours_of(members, box);
  for (const SwarmMember& member : members) swarm.kinetic_energy += member.kinetic_energy;
  return swarm;
}

}  // namespace beadswim
