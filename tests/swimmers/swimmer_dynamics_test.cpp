#include "beadswim/swimmers/swimmer_dynamics.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace beadswim {
namespace {

/// Returns a swimmer whose outer beads oscillate in opposite directions while bead 2 rests: x1 = -l - s, x3 =
/// l + s with m s'' + c s' + k s = 0.
SwimmerType symmetric_swimmer() {
  SwimmerType type;
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
  const SwimmerType type = symmetric_swimmer();
  constexpr double s0 = 0.3, duration = 16;
  SwimmerMotion motion;
  motion[0].position = Vec3(-5 - s0, 0, 0);
  motion[2].position = Vec3(5 + s0, 0, 0);
  double error = 0;
  for (int n = 1; n <= std::lround(duration / step); ++n) {
    advance_swimmer(motion, type, Vec3::UnitX(), {}, (n - 1) * step, step, 1);
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
  SwimmerType type = symmetric_swimmer();
  type.angular_stiffness = 4;
  const double m = mass(type.beads[0]);
  const double omega = std::sqrt(type.angular_stiffness * 6 / (25 * m));
  constexpr double bend = 1e-4;
  SwimmerMotion motion;
  motion[0].position = Vec3(-5, bend, 0);
  motion[1].position = Vec3(0, -2 * bend, 0);
  motion[2].position = Vec3(5, bend, 0);
  const double half_period = std::numbers::pi / omega;
  advance_swimmer(motion, type, Vec3::UnitX(), {}, 0, half_period, 200);
  constexpr double model = 1e-6;  // angle^2, and the step^4
  EXPECT_NEAR(motion[1].position[1] / (2 * bend), 1, model);
  EXPECT_NEAR(motion[0].position[1] / (-bend), 1, model);
}

TEST(FreeBead, AcceleratesAndSpinsUpUnderAConstantLoad) {
  SwimmerType type = symmetric_swimmer();
  type.springs.fill({.stiffness = 0, .rest_length = 5, .damping = 0});
  SwimmerMotion motion;
  motion[0].position = Vec3(-5, 0, 0);
  motion[2].position = Vec3(5, 0, 0);
  SwimmerLoads loads;
  loads[1] = {.force = Vec3(0, 2, 0), .torque = Vec3(0, 0, 3)};
  advance_swimmer(motion, type, Vec3::UnitX(), loads, 0, 4, 3);
  const double m = mass(type.beads[1]);
  constexpr double roundoff = 1e-13;
  EXPECT_NEAR(motion[1].position[1], 0.5 * 2 / m * 16, 16 * roundoff);
  EXPECT_NEAR(motion[1].angular_velocity[2], 3 * 4 / (0.4 * m), 16 * roundoff);
}

// The sub-step keeps a stiff swimmer within the integrator's stability: energy must not grow.
TEST(SubSteps, KeepAStiffSwimmerStable) {
  SwimmerType type = symmetric_swimmer();
  type.springs.fill({.stiffness = 4e4, .rest_length = 5, .damping = 0});
  type.angular_stiffness = 1e6;
  const int substeps = substeps_for(type, 1);
  EXPECT_GT(substeps, 100);
  SwimmerMotion motion;
  motion[0].position = Vec3(-5.01, 0.01, 0);
  motion[2].position = Vec3(5.02, 0, 0.01);
  for (int n = 0; n < 200; ++n) advance_swimmer(motion, type, Vec3::UnitX(), {}, n, 1, substeps);
  EXPECT_LT((motion[2].position - motion[0].position - Vec3(10, 0, 0)).norm(), 0.05);
  EXPECT_EQ(substeps_for(symmetric_swimmer(), 0.01), 1);
}

// A spring whose vibration the step resolves stays as it is; a stiffer one gets k step/2, or half of
// critical, and keeps what it has if that is more.
TEST(StiffSprings, GetADashpotWhereStepsAreTooLong) {
  SwimmerType type = symmetric_swimmer();
  const double reduced_mass = 0.5 * mass(type.beads[0]);
  const auto damping = [&](double omega_step, double own) {
    type.springs.fill(
        {.stiffness = reduced_mass * omega_step * omega_step, .rest_length = 5, .damping = own});
    return with_resolved_vibrations(type, 1).springs[1].damping;
  };
  EXPECT_EQ(damping(0.4, 0), 0);
  EXPECT_NEAR(damping(1, 0), 0.5 * reduced_mass, 1e-12);
  EXPECT_NEAR(damping(30, 0), 30 * reduced_mass, 1e-12);
  EXPECT_EQ(damping(1, 7), 7);
}

// Bent a little and let go, the swimmer vibrates at omega; softened, at 3/4 rad a step, and not if slower.
TEST(StiffAngularSpring, IsSoftenedToWhatStepsFollow) {
  SwimmerType type = symmetric_swimmer();
  const double l = type.springs[0].rest_length;
  const double per_stiffness = 6 / (mass(type.beads[0]) * l * l);  // omega^2 = K (1 + 4 + 1)/(m l^2)
  const double step = 0.02;
  type.angular_stiffness = std::pow(0.7 / step, 2) / per_stiffness;
  EXPECT_EQ(with_resolved_vibrations(type, step).angular_stiffness, type.angular_stiffness);

  type.angular_stiffness *= 1e4;
  const SwimmerType softened = with_resolved_vibrations(type, step);
  constexpr double bend = 1e-6;
  SwimmerMotion motion;
  motion[0].position = Vec3(-l, bend, 0);
  motion[1].position = Vec3(0, -2 * bend, 0);
  motion[2].position = Vec3(l, bend, 0);
  constexpr int substeps = 40;
  advance_swimmer(motion, softened, Vec3::UnitX(), {}, 0, step, substeps);
  EXPECT_NEAR(motion[0].position[1], bend * std::cos(0.75), 1e-4 * bend);
}

}  // namespace
}  // namespace beadswim
