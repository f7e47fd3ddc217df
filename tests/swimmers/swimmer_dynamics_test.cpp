#include "beadswim/swimmers/swimmer_dynamics.hpp"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <cmath>
#include <numbers>
#include <random>

#include "bead_vectors.hpp"
#include "beadswim/swimmers/three_bead_swimmer.hpp"

namespace beadswim {
namespace {

/// Returns a swimmer whose outer beads oscillate in opposite directions while bead 2 rests: x1 = -l - s, x3 =
/// l + s with m s'' + c s' + k s = 0.
ThreeBeadSwimmer symmetric_swimmer() {
  ThreeBeadSwimmer type;
  type.beads.fill({.radius = 1, .density = 0.5});
  type.springs.fill({.stiffness = 1.3, .rest_length = 5, .damping = 0.2});
  type.driving = {.amplitude = {0, 0}, .phase = 0, .period = 10, .frame = DrivingFrame::lab};
  return type;
}

/// Returns the position s(t) of a damped oscillator that begins at rest at s(0) = s0.
double damped_oscillation(double m, double c, double k, double s0, double t) {
  const double decay = c / (2 * m), omega = std::sqrt(k / m - decay * decay);
  return s0 * std::exp(-decay * t) * (std::cos(omega * t) + decay / omega * std::sin(omega * t));
}

/// Returns the largest error of the position in two periods.
double oscillation_error(double step) {
  const SwimmerType type = swimmer_type(symmetric_swimmer());
  constexpr double s0 = 0.3, duration = 16;
  SwimmerMotion motion(3);
  motion[0].position = Vec3(-5 - s0, 0, 0);
  motion[2].position = Vec3(5 + s0, 0, 0);
  double error = 0;
  for (int n = 1; n <= std::lround(duration / step); ++n) {
    advance_swimmer(motion, type, Eigen::Matrix3d::Identity(), SwimmerLoads(3), (n - 1) * step, step, 1);
    const double exact = damped_oscillation(mass(type.beads[0]), 0.2, 1.3, s0, n * step);
    error = std::max(error, std::abs(motion[2].position[0] - 5 - exact));
  }
  return error;
}

// Catches a wrong dashpot, mass or stage of the integrator.
TEST(SpringAndDashpot, OscillateAsTheAnalyticSolutionToFourthOrder) {
  const std::array errors{oscillation_error(0.4), oscillation_error(0.2), oscillation_error(0.1)};
  for (int fine = 1; fine < 3; ++fine) {
    const double order = std::log2(errors[fine - 1] / errors[fine]);
    EXPECT_GT(order, 3.7);
    EXPECT_LT(order, 4.5);
  }
  EXPECT_LT(errors[2], 1e-5);
}

/// Bending, small angles: theta'' = -K_A sum(g_i^2/m_i) theta with g = (1/l, -2/l, 1/l).
TEST(AngularSpring, BendsAtTheAnalyticFrequency) {
  SwimmerType type = swimmer_type(symmetric_swimmer());
  type.angles[0].stiffness = 4;
  const double m = mass(type.beads[0]);
  const double omega = std::sqrt(type.angles[0].stiffness * 6 / (25 * m));
  constexpr double bend = 1e-4;
  SwimmerMotion motion(3);
  motion[0].position = Vec3(-5, bend, 0);
  motion[1].position = Vec3(0, -2 * bend, 0);
  motion[2].position = Vec3(5, bend, 0);
  const double half_period = std::numbers::pi / omega;
  advance_swimmer(motion, type, Eigen::Matrix3d::Identity(), SwimmerLoads(3), 0, half_period, 200);
  constexpr double model = 1e-6;  // angle^2, and the step^4
  EXPECT_NEAR(motion[1].position[1] / (2 * bend), 1, model);
  EXPECT_NEAR(motion[0].position[1] / (-bend), 1, model);
}

TEST(FreeBead, AcceleratesAndSpinsUpUnderAConstantLoad) {
  SwimmerType type = swimmer_type(symmetric_swimmer());
  for (Bond& bond : type.bonds) bond.stiffness = bond.damping = 0;
  SwimmerMotion motion(3);
  motion[0].position = Vec3(-5, 0, 0);
  motion[2].position = Vec3(5, 0, 0);
  SwimmerLoads loads(3);
  loads[1] = {.force = Vec3(0, 2, 0), .torque = Vec3(0, 0, 3)};
  advance_swimmer(motion, type, Eigen::Matrix3d::Identity(), loads, 0, 4, 3);
  const double m = mass(type.beads[1]);
  constexpr double roundoff = 1e-13;
  EXPECT_NEAR(motion[1].position[1], 0.5 * 2 / m * 16, 16 * roundoff);
  EXPECT_NEAR(motion[1].angular_velocity[2], 3 * 4 / (0.4 * m), 16 * roundoff);
}

// The sub-step keeps a stiff swimmer within the integrator's stability: energy must not grow.
TEST(SubSteps, KeepAStiffSwimmerStable) {
  ThreeBeadSwimmer stiff = symmetric_swimmer();
  stiff.springs.fill({.stiffness = 4e4, .rest_length = 5, .damping = 0});
  stiff.angular_stiffness = 1e6;
  const SwimmerType type = swimmer_type(stiff);
  const int substeps = substeps_for(type, 1);
  EXPECT_GT(substeps, 100);
  SwimmerMotion motion(3);
  motion[0].position = Vec3(-5.01, 0.01, 0);
  motion[2].position = Vec3(5.02, 0, 0.01);
  for (int n = 0; n < 200; ++n)
    advance_swimmer(motion, type, Eigen::Matrix3d::Identity(), SwimmerLoads(3), n, 1, substeps);
  EXPECT_LT((motion[2].position - motion[0].position - Vec3(10, 0, 0)).norm(), 0.05);
  EXPECT_EQ(substeps_for(swimmer_type(symmetric_swimmer()), 0.01), 1);
}

/// Returns eight beads of different masses in a chain, with bonds of different stiffness and an angular
/// spring at each inner bead. `turn` takes each bond to the next.
SwimmerType chain_of_eight(const Eigen::Matrix3d& turn, double bond_stiffness, double angular_stiffness) {
  SwimmerType type;
  Vec3 at = Vec3::Zero(), bond = 5 * Vec3::UnitX();
  for (int b = 0; b < 8; ++b) {
    type.beads.push_back({{.radius = 1 + 0.05 * b, .density = 0.5}, at});
    at += bond;
    bond = turn * bond;
    if (b < 7) type.bonds.push_back({{bond_stiffness * (1 + 0.1 * b), 5, 0}, {b, b + 1}});
  }
  for (int b = 0; b < 6; ++b) {
    const Vec3 first = type.beads[b + 1].at - type.beads[b].at,
               second = type.beads[b + 2].at - type.beads[b + 1].at;
    type.angles.push_back({.beads = {b, b + 1, b + 2},
                           .stiffness = angular_stiffness * (1 + 0.1 * b),
                           .rest = std::acos(std::min(1.0, first.dot(second) / 25))});
  }
  type.driving.period = 1;
  return type;
}

/// Returns the largest angular frequency of small vibrations, from central differences of the forces at rest.
double fastest_vibration(const SwimmerType& type) {
  const BeadVectors rest = columns(rest_positions(type, Vec3::Zero(), Eigen::Matrix3d::Identity()));
  const auto size = rest.size();
  const auto forces = [&](Eigen::Index component, double displacement) {
    BeadVectors at = rest;
    at.reshaped()[component] += displacement;
    const BeadVectors force =
        bond_forces(type, 0, at, BeadVectors::Zero(3, at.cols())) + angle_forces(type, 0, at);
    return Eigen::VectorXd(force.reshaped());
  };
  constexpr double h = 1e-5;
  Eigen::MatrixXd stiffness(size, size);
  Eigen::VectorXd root_mass(size);
  for (Eigen::Index c = 0; c < size; ++c) {
    stiffness.col(c) = (forces(c, -h) - forces(c, h)) / (2 * h);
    root_mass[c] = std::sqrt(mass(type.beads[c / 3]));
  }
  const Eigen::MatrixXd scaled = stiffness.cwiseQuotient(root_mass * root_mass.transpose());
  return std::sqrt(Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(scaled).eigenvalues().maxCoeff());
}

// Catches vibrations of several bonds and angles together that are faster than those of one alone.
TEST(SubSteps, ResolveAllVibrationsOfAChain) {
  constexpr double step = 100;
  std::mt19937 random(1);
  const Eigen::Matrix3d straight = Eigen::Matrix3d::Identity();
  for (const double angular_stiffness : {0.0, 5.0, 10.0, 20.0, 40.0, 1000.0}) {
    for (const Eigen::Matrix3d& turn : {straight, random_rotation(random), random_rotation(random)}) {
      const SwimmerType type = chain_of_eight(turn, 2, angular_stiffness);
      const double angle_in_substep = fastest_vibration(type) * step / substeps_for(type, step);
      EXPECT_LE(angle_in_substep, 0.25) << angular_stiffness << "\n" << turn;
      EXPECT_GT(angle_in_substep, 0.1);  // and there are not many times too many
    }
  }
}

// Bonds and angle of a bent swimmer vibrate together, faster than each alone.
TEST(Substeps, ResolveStretchingWithBending) {
  std::mt19937 random(7);
  const auto uniform = [&](double low, double high) {
    return std::uniform_real_distribution(low, high)(random);
  };
  double largest = 0;
  for (int trial = 0; trial < 1000; ++trial) {
    const double theta = uniform(0.2, 2.6), first = uniform(5, 10), second = uniform(5, 10);
    SwimmerType type;
    type.beads = {
        {{.radius = uniform(0.5, 2), .density = 1}, Vec3(-first, 0, 0)},
        {{.radius = uniform(0.5, 2), .density = 1}, Vec3(0, 0, 0)},
        {{.radius = uniform(0.5, 2), .density = 1}, second * Vec3(std::cos(theta), std::sin(theta), 0)}};
    type.bonds = {{{uniform(0, 1), first, 0}, {0, 1}}, {{uniform(0, 1), second, 0}, {1, 2}}};
    type.angles = {{.beads = {0, 1, 2}, .stiffness = uniform(0, 100), .rest = theta}};
    type.driving.period = 1;
    constexpr double step = 500;
    largest = std::max(largest, fastest_vibration(type) * step / substeps_for(type, step));
  }
  EXPECT_LE(largest, 0.25);
  EXPECT_GT(largest, 0.2);
}

// A spring whose vibration the step resolves stays as it is; a stiffer one gets k step/2, or half of
// critical, and keeps what it has if that is more.
TEST(StiffSprings, GetADashpotWhereStepsAreTooLong) {
  ThreeBeadSwimmer type = symmetric_swimmer();
  const double reduced_mass = 0.5 * mass(type.beads[0]);
  const auto damping = [&](double omega_step, double own) {
    type.springs.fill(
        {.stiffness = reduced_mass * omega_step * omega_step, .rest_length = 5, .damping = own});
    return with_resolved_vibrations(swimmer_type(type), 1).bonds[1].damping;
  };
  EXPECT_EQ(damping(0.4, 0), 0);
  EXPECT_NEAR(damping(1, 0), 0.5 * reduced_mass, 1e-12);
  EXPECT_NEAR(damping(30, 0), 30 * reduced_mass, 1e-12);
  EXPECT_EQ(damping(1, 7), 7);
}

// Bent a little and let go, the swimmer vibrates at omega; softened, at 3/4 rad a step, and not if slower.
TEST(StiffAngularSpring, IsSoftenedToWhatStepsFollow) {
  SwimmerType type = swimmer_type(symmetric_swimmer());
  double& stiffness = type.angles[0].stiffness;
  const double l = type.bonds[0].rest_length;
  const double per_stiffness = 6 / (mass(type.beads[0]) * l * l);  // omega^2 = K (1 + 4 + 1)/(m l^2)
  const double step = 0.02;
  stiffness = std::pow(0.7 / step, 2) / per_stiffness;
  EXPECT_EQ(with_resolved_vibrations(type, step).angles[0].stiffness, stiffness);

  stiffness *= 1e4;
  const SwimmerType softened = with_resolved_vibrations(type, step);
  constexpr double bend = 1e-6;
  SwimmerMotion motion(3);
  motion[0].position = Vec3(-l, bend, 0);
  motion[1].position = Vec3(0, -2 * bend, 0);
  motion[2].position = Vec3(l, bend, 0);
  constexpr int substeps = 40;
  advance_swimmer(motion, softened, Eigen::Matrix3d::Identity(), SwimmerLoads(3), 0, step, substeps);
  EXPECT_NEAR(motion[0].position[1], bend * std::cos(0.75), 1e-4 * bend);
}

}  // namespace
}  // namespace beadswim
