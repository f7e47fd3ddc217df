#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>

#include "beadswim/collinear/oseen.hpp"
#include "beadswim/core/error.hpp"
#include "beadswim/swimmers/three_bead_swimmer.hpp"
#include "beadswim/theory/shaped_swimmer.hpp"
#include "shape_cycle.hpp"
#include "shape_flow.hpp"

// Swimmers over a plane no-slip wall and in background flow, against formulas for one sphere and for force
// dipoles far from the wall.

namespace beadswim {
namespace {

constexpr double pi = std::numbers::pi, eta = 0.5;

/// Returns one bead of radius 1 with a constant force on it.
ShapedSwimmer towed_bead(const Vec3& force, double height) {
  SwimmerType type;
  type.beads = {{{.radius = 1, .density = 1}, Vec3::Zero()}};
  type.driving.period = 0.01;
  type.driving.forces = {{.bead = 0, .direction = force.normalized(), .constant = force.norm()}};
  return {.type = type,
          .orientation = Eigen::Matrix3d::Identity(),
          .viscosity = eta,
          .domain = {.box = {}, .half_space = HalfSpace{}},
          .flow = {},
          .place = Vec3(3, -2, height)};
}

TEST(ShapesOverAWall, ATowedBeadMovesAsByTheFormula) {
  const double stokes = 1 / (6 * pi * eta);
  for (const double H : {1.5, 3.0, 20.0}) {
    const double along = 1 - (9 / H - 2 / std::pow(H, 3) + 1 / std::pow(H, 5)) / 16;
    const double across = 1 - (9 / H - 4 / std::pow(H, 3) + 1 / std::pow(H, 5)) / 8;
    for (const Vec3& force : {Vec3(1e-4, 0, 0), Vec3(0, 0, -1e-4), Vec3(1e-4, 2e-4, 1e-4)}) {
      const Vec3 expected = stokes * force.cwiseProduct(Vec3(along, along, across));
      const Vec3 rpy = periodic_motion(towed_bead(force, H), rotne_prager_tensor).velocity_vector;
      EXPECT_LT((rpy - expected).norm(), 1e-6 * expected.norm());
      const Vec3 of_points =
          stokes * force.cwiseProduct(Vec3(1 - 9 / (16 * H), 1 - 9 / (16 * H), 1 - 9 / (8 * H)));
      EXPECT_LT((periodic_motion(towed_bead(force, H), oseen_pairs).velocity_vector - of_points).norm(),
                1e-6 * expected.norm());
    }
  }
}

// The mobility of a point force across the wall, 1 - 9/(8 H), is not positive.
TEST(ShapesOverAWall, RefusesOseenWhereItsMobilityIsNotPositive) {
  for (const double H : {1.01, 1.1, 1.124})
    EXPECT_THROW(periodic_motion(towed_bead(Vec3(1e-4, 0, 0), H), oseen_pairs), InputError);
  EXPECT_GT(periodic_motion(towed_bead(Vec3(0, 0, 1e-4), 1.13), oseen_pairs).velocity_vector.z(), 0);
}

/// Returns three beads with arms of these lengths, at the pitch angle above the x axis.
ShapedSwimmer swimmer(const std::array<double, 2>& arms, double phase, double pitch) {
  ThreeBeadSwimmer three;
  for (int b = 0; b < 3; ++b) three.beads[b] = {2, 1};
  for (int k = 0; k < 2; ++k) three.springs[k] = {0.05, arms[k], 0};
  three.angular_stiffness = 100;
  three.driving = {.amplitude = {0.1, 0.1}, .phase = phase, .period = 1000, .frame = DrivingFrame::body};
  return {.type = swimmer_type(three),
          .orientation = Eigen::AngleAxisd(-pitch, Vec3::UnitY()).toRotationMatrix(),
          .viscosity = eta};
}

/// Returns the mean of sum x_i f_i along the axis of a swimmer in open space: positive for a pusher.
double mean_dipole(const ShapedSwimmer& alone) {
  BeadVectors start = relaxed_shape(alone);
  constexpr int steps = 256, cycles = 40;
  ShapeCycle cycle;
  const ShapeMobility mobility = pair_mobility(alone, rotne_prager_tensor);
  for (int n = 0; n < cycles; ++n) {
    cycle = *integrate_cycle(alone, mobility, start, steps);
    start = centred(cycle.beads.back());
  }
  const ShapeFlow flow(alone, mobility);
  double dipole = 0;
  for (int s = 0; s < steps; ++s) {
    const BeadVectors forces = as_beads(flow.forces(cycle.beads[s], alone.type.driving.period * s / steps));
    const Eigen::RowVectorXd x = alone.orientation.col(0).transpose() * centred(cycle.beads[s]);
    dipole += x.dot(alone.orientation.col(0).transpose() * forces) / steps;
  }
  return dipole;
}

/// Extrapolates values at 1/h, 1/(2h) and 1/(4h) to 1/h = 0.
double far_limit(const std::array<double, 3>& f) {
  return (8 * f[2] - 6 * f[1] + f[0]) / 3;
}

// Far from the wall, a swimmer moves and turns in the image flow of its force dipole p, at the pitch angle a:
//
//   u_x = 3 p sin 2a/(64 pi eta h^2),   u_z = -3 p (1 - 3 sin^2 a)/(64 pi eta h^2)
//   rate of the pitch angle = -3 p sin 2a/(128 pi eta h^3) (1 + (1 + sin^2 a)/2)      for a slender body
//
// A pusher along the wall is attracted and turns parallel to the wall; a puller is repelled and turns away.
// Berke, Turner, Berg & Lauga, Phys. Rev. Lett. 101 (2008) 038102; Spagnolie & Lauga, J. Fluid Mech. 700
// (2012) 105.
TEST(ShapesOverAWall, FarFromItASwimmerFollowsTheImageOfItsDipole) {
  constexpr double phase = 1.5;
  for (const auto& [arms, is_pusher, pitches] :
       {std::tuple{std::array{10.0, 20.0}, true, std::vector{0.0, 0.4}},
        {std::array{20.0, 10.0}, false, std::vector{-0.9}}}) {
    const double p = mean_dipole(swimmer(arms, phase, 0));
    EXPECT_EQ(p > 0, is_pusher);
    for (const double pitch : pitches) {
      ShapedSwimmer placed = swimmer(arms, phase, pitch);
      const Vec3 free = periodic_motion(placed, rotne_prager_tensor).velocity_vector;
      placed.domain.half_space = HalfSpace{};
      std::array<double, 3> along, across, turning;
      for (int n = 0; n < 3; ++n) {
        const double h = 300 * std::pow(2, n);
        placed.place = Vec3(0, 0, h);
        const ShapeMotion motion = periodic_motion(placed, rotne_prager_tensor);
        along[n] = (motion.velocity_vector.x() - free.x()) * h * h;
        across[n] = (motion.velocity_vector.z() - free.z()) * h * h;
        turning[n] = -motion.angular_velocity.y() * h * h * h;  // about -y the pitch angle increases
      }
      const double unit = 3 * p / (64 * pi * eta), s = std::sin(pitch);
      EXPECT_NEAR(far_limit(along) / unit, std::sin(2 * pitch), 5e-4);
      EXPECT_NEAR(far_limit(across) / unit, -(1 - 3 * s * s), 5e-4);
      EXPECT_NEAR(far_limit(turning) / unit, -std::sin(2 * pitch) / 2 * (1 + (1 + s * s) / 2), 2e-3);
    }
  }
}

}  // namespace
}  // namespace beadswim
