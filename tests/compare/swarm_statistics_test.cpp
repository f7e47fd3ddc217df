// Tests of swarm statistics with swarms whose order, spreads and rotations are known exactly.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "beadswim/compare/swarm_statistics.hpp"
#include "beadswim/core/keyed_random.hpp"
#include "tolerances.hpp"

namespace beadswim {
namespace {

constexpr double pi = std::numbers::pi;
constexpr std::uint64_t seed = 5;
const Box periodic_box{.lengths = {100, 80, 60}, .boundary = {}};
const Box closed_box{.lengths = {100, 80, 60},
                     .boundary = {Boundary::free_slip, Boundary::free_slip, Boundary::free_slip}};

const Vec3 tilted = Vec3(2, -1, 2) / 3;
const Vec3 across = Vec3(1, 2, 0) / std::sqrt(5.0);  // to tilted

SwarmStatistics statistics_of(const std::vector<SwarmMember>& members) {
  return swarm_statistics(1, members, periodic_box);
}

SwarmMember with_axis(const Vec3& axis) {
  SwarmMember member;
  member.axis = axis;
  return member;
}

SwarmMember with_cycle(const CycleStatistics& cycle) {
  SwarmMember member;
  member.last_cycle = cycle;
  return member;
}

/// Returns swimmers whose axes are evenly spaced on a cone with the half angle theta around a tilted line.
std::vector<SwarmMember> cone(int count, double theta) {
  std::vector<SwarmMember> members;
  for (int i = 0; i < count; ++i) {
    const Vec3 around = Eigen::AngleAxisd(2 * pi * i / count, tilted) * across;
    members.push_back(with_axis(std::cos(theta) * tilted + std::sin(theta) * around));
  }
  return members;
}

std::vector<SwarmMember> isotropic(std::uint64_t count, std::uint64_t swarm) {
  std::vector<SwarmMember> members;
  for (std::uint64_t i = 0; i < count; ++i) {
    members.push_back(with_axis(KeyedRandom(seed, i, swarm).direction()));
  }
  return members;
}

/// Returns one swimmer per value in `phases`: phase of arm 1. The phase of arm 2 is -1/2 of this value.
std::vector<SwarmMember> with_phases(const std::vector<double>& phases) {
  std::vector<SwarmMember> members;
  for (const double phase : phases) {
    CycleStatistics cycle;
    cycle.arm_amplitudes = cycle.arm_means = {1, 1};
    cycle.arm_phases = {phase, -0.5 * phase};
    members.push_back(with_cycle(cycle));
  }
  return members;
}

// --- order of the axes

TEST(SwarmOrder, OfParallelAxesIsComplete) {
  const SwarmStatistics swarm = statistics_of(std::vector(1000, with_axis(tilted)));
  EXPECT_NEAR(swarm.polar_order, 1, roundoff(4));
  EXPECT_NEAR((swarm.mean_axis - tilted).norm(), 0, roundoff(4));
  EXPECT_NEAR(swarm.nematic_order, 1, roundoff(1000));
  EXPECT_NEAR((swarm.director - tilted).norm(), 0, roundoff(1000));
}

// Would catch a nematic order that tells heads from tails.
TEST(SwarmOrder, OfAxesHalfAntiparallelIsNematicAlone) {
  std::vector<SwarmMember> members(1000, with_axis(-tilted));
  std::fill(members.begin(), members.begin() + 500, with_axis(tilted));
  const SwarmStatistics swarm = statistics_of(members);
  EXPECT_NEAR(swarm.polar_order, 0, roundoff(1000));
  EXPECT_NEAR(swarm.nematic_order, 1, roundoff(1000));
}

// Axes at the angle theta to a line, evenly round it: the eigenvalues are (3 cos^2 - 1)/2 along the line and
// (3 sin^2/2 - 1)/2 twice across it. The latter is the larger beyond the magic angle of 54.7 degrees.
TEST(SwarmOrder, OfAConeIsThatOfItsAngle) {
  for (const double theta : {0.1, 0.6, 0.95, 1.0, 1.3, pi / 2}) {
    const double c = std::cos(theta), s = std::sin(theta);
    const double along = (3 * c * c - 1) / 2, beside = (1.5 * s * s - 1) / 2;
    const SwarmStatistics swarm = statistics_of(cone(12, theta));
    EXPECT_NEAR((swarm.mean_axis - c * tilted).norm(), 0, roundoff(50));
    EXPECT_NEAR(swarm.polar_order, c, roundoff(50));
    EXPECT_NEAR(swarm.nematic_order, std::max(along, beside), roundoff(50));
    if (along > beside) {
      EXPECT_NEAR((swarm.director - tilted).norm(), 0, roundoff(1000)) << theta;
    }
    EXPECT_NEAR(swarm.director.norm(), 1, roundoff(10));
  }
}

// Of N random axes, for large N: each component of the mean has the variance 1/(3 N), each off the diagonal
// of the nematic tensor 3/(20 N). 400 swarms give both means to 2 %, of which 3 times as much is let pass.
TEST(SwarmOrder, OfIsotropicAxesIsThatOfASample) {
  constexpr int swarms = 400, count = 250;
  double polar = 0, nematic = 0;
  for (int i = 0; i < swarms; ++i) {
    const SwarmStatistics swarm = statistics_of(isotropic(count, i));
    polar += swarm.polar_order / swarms;
    nematic += swarm.nematic_order / swarms;
  }
  EXPECT_NEAR(polar * std::sqrt(count), std::sqrt(8 / (3 * pi)), 0.06) << "seed " << seed;
  EXPECT_NEAR(nematic * std::sqrt(count), 9.0 / 4 * std::sqrt(2 / (5 * pi)), 0.05) << "seed " << seed;
}

TEST(SwarmOrder, TurnsWithTheSwarm) {
  std::vector<SwarmMember> members = isotropic(20, 1);
  const SwarmStatistics before = statistics_of(members);
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(1.1, Vec3(1, 5, -2).normalized()).toRotationMatrix();
  for (SwarmMember& member : members) member.axis = turn * member.axis;
  const SwarmStatistics after = statistics_of(members);
  EXPECT_NEAR((after.mean_axis - turn * before.mean_axis).norm(), 0, roundoff(100));
  EXPECT_NEAR(after.nematic_order, before.nematic_order, roundoff(100));
  EXPECT_NEAR(std::abs(after.director.dot(turn * before.director)), 1, roundoff(1000));
}

TEST(SwarmOrder, GivesTheDirectorTheSignOfItsLargestComponent) {
  EXPECT_NEAR((statistics_of({with_axis(Vec3(0.6, -0.8, 0))}).director - Vec3(-0.6, 0.8, 0)).norm(), 0,
              roundoff(50));
}

// --- rotation

// Would catch an arc cosine of the scalar product, which takes an angle of 1e-9 for zero.
TEST(SwarmRotation, IsTheAngleToTheInitialAxis) {
  const std::vector<double> angles{1e-9, 0.3, pi / 2, pi};
  for (const double angle : angles) {
    SwarmMember member = with_axis(std::cos(angle) * tilted - std::sin(angle) * across);
    member.initial_axis = tilted;
    EXPECT_NEAR(statistics_of({member}).rotation.mean, angle, roundoff(4));
  }
}

// --- phases

// Two groups at +-beta have order cos(beta). Would catch means of phases, which tear at +-pi.
TEST(SwarmPhases, OfTwoGroupsHaveTheCosineOfHalfTheirDistance) {
  for (const double middle : {0.0, 2.0, pi}) {
    for (const double beta : {0.0, 0.4, 1.2}) {
      const double first = std::remainder(middle + beta, 2 * pi);
      const double second = std::remainder(middle - beta, 2 * pi);
      const SwarmStatistics swarm = statistics_of(with_phases({first, second, second, first}));
      EXPECT_NEAR(swarm.swimming->arm_phase_order[0], std::cos(beta), roundoff(20));
      EXPECT_NEAR(swarm.swimming->arm_phase_order[1], std::abs(std::cos(0.25 * (first - second))),
                  roundoff(20));
    }
  }
}

TEST(SwarmPhases, SpreadEvenlyHaveNoOrder) {
  constexpr int count = 120;
  std::vector<double> phases;
  for (int i = 0; i < count; ++i) phases.push_back(2 * pi * i / count - pi / 3);
  EXPECT_NEAR(statistics_of(with_phases(phases)).swimming->arm_phase_order[0], 0, roundoff(count));
}

// --- spreads

/// Returns `count` swimmers. Each quantity of swimmer i is an arithmetic sequence in i, with its own
/// increment.
std::vector<SwarmMember> ladder(int count, const Vec3& wind) {
  std::vector<SwarmMember> members;
  for (int i = 1; i <= count; ++i) {
    CycleStatistics cycle;
    cycle.velocity = wind + i * Vec3(1, -2, 3);
    cycle.speed_along_axis = 7.0 * i;
    cycle.mean_flow = wind + Vec3(i, 0, 1);
    cycle.arm_amplitudes = {2.0 * i, 3.0 * i};
    cycle.arm_phases = {0, 0};
    cycle.arm_means = {20 + 1.0 * i, 40 - 1.0 * i};
    SwarmMember member = with_cycle(cycle);
    member.kinetic_energy = i;
    member.centre = Vec3(1.5 * i * i, 0, 0);
    members.push_back(member);
  }
  return members;
}

void expect_spread(const Spread& spread, double mean, double deviation, double smallest, double largest) {
  EXPECT_NEAR(spread.mean, mean, std::abs(mean) * roundoff(10));
  EXPECT_NEAR(spread.deviation, deviation, deviation * roundoff(10));
  EXPECT_EQ(spread.smallest, smallest);
  EXPECT_EQ(spread.largest, largest);
}

// 1, 2, ..., N have the mean (N + 1)/2 and the variance (N^2 - 1)/12: would catch N - 1 in its place.
TEST(SwarmSpreads, OfEvenStepsAreKnown) {
  constexpr int n = 9;
  const double mean = (n + 1) / 2.0, deviation = std::sqrt((n * n - 1) / 12.0);
  const SwarmStatistics swarm = statistics_of(ladder(n, Vec3::Zero()));
  const SwarmSwimming& swimming = *swarm.swimming;
  EXPECT_NEAR((swimming.velocity - mean * Vec3(1, -2, 3)).norm(), 0, roundoff(200));
  EXPECT_NEAR((swimming.velocity_deviation - deviation * Vec3(1, 2, 3)).norm(), 0, roundoff(200));
  expect_spread(swimming.speed_along_axis, 7 * mean, 7 * deviation, 7, 7 * n);
  EXPECT_NEAR((swimming.mean_flow - Vec3(mean, 0, 1)).norm(), 0, roundoff(100));
  for (int arm = 0; arm < 2; ++arm) {
    const double step = arm + 2;
    expect_spread(swimming.arm_amplitudes[arm], step * mean, step * deviation, step, step * n);
  }
  expect_spread(swimming.arm_means[0], 20 + mean, deviation, 21, 20 + n);
  expect_spread(swimming.arm_means[1], 40 - mean, deviation, 40 - n, 39);
  EXPECT_EQ(swarm.kinetic_energy, n * mean);
}

// Would catch <v^2> - <v>^2, of which a wind of 1e9 leaves nothing.
TEST(SwarmSpreads, DoNotFeelAWind) {
  constexpr double wind = 1e9;
  const SwarmSwimming calm = *statistics_of(ladder(50, Vec3::Zero())).swimming;
  const SwarmSwimming windy = *statistics_of(ladder(50, Vec3(wind, -wind, 0))).swimming;
  EXPECT_NEAR((windy.velocity_deviation - calm.velocity_deviation).norm(), 0, roundoff(1000));
  EXPECT_NEAR((windy.velocity - calm.velocity - Vec3(wind, -wind, 0)).norm(), 0, wind * roundoff(2));
}

// Would catch the rounding of sums of 100,000 equal terms told as a spread.
TEST(SwarmSpreads, OfEqualSwimmersAreExactlyZero) {
  CycleStatistics cycle;
  cycle.speed_along_axis = 0.1;
  const SwarmStatistics swarm = statistics_of(std::vector(100'000, with_cycle(cycle)));
  expect_spread(swarm.swimming->speed_along_axis, 0.1, 0, 0.1, 0.1);
}

// Centres at 1.5, 6 and 13.5 have their neighbours 4.5, 4.5 and 7.5 away.
TEST(SwarmSpreads, OfNearestNeighboursAreThoseOfCentres) {
  const SwarmStatistics swarm = statistics_of(ladder(3, Vec3::Zero()));
  expect_spread(*swarm.nearest_neighbour, 5.5, std::sqrt(2.0), 4.5, 7.5);
}

// --- swimmers without a cycle

TEST(SwarmStatistics, TakesSwimmingFromThoseWithACycleAlone) {
  std::vector<SwarmMember> members = ladder(3, Vec3::Zero());
  members[1].last_cycle.reset();
  const SwarmStatistics swarm = swarm_statistics(4, members, closed_box);
  EXPECT_EQ(swarm.index, 4);
  EXPECT_EQ(swarm.swimmers, 3);
  EXPECT_EQ(swarm.swimming->swimmers, 2);
  expect_spread(swarm.swimming->speed_along_axis, 14, 7, 7, 21);
  EXPECT_EQ(swarm.kinetic_energy, 6);
}

TEST(SwarmStatistics, KnowsNoSwimmingBeforeACycleHasEnded) {
  const SwarmStatistics swarm = statistics_of(cone(5, 0.2));
  EXPECT_FALSE(swarm.swimming.has_value());
  EXPECT_NEAR(swarm.polar_order, std::cos(0.2), roundoff(20));
}

TEST(SwarmStatistics, OfALoneSwimmer) {
  const std::vector<SwarmMember> lone{with_axis(tilted)};
  EXPECT_EQ(statistics_of(lone).nearest_neighbour->mean, 60);
  EXPECT_FALSE(swarm_statistics(1, lone, closed_box).nearest_neighbour.has_value());
}

TEST(SwarmStatistics, OfNobodyAreNone) {
  const SwarmStatistics swarm = statistics_of({});
  EXPECT_EQ(swarm.swimmers, 0);
  EXPECT_EQ(swarm.nematic_order, 0);
  EXPECT_FALSE(swarm.swimming || swarm.nearest_neighbour);
}

}  // namespace
}  // namespace beadswim
