#include "beadswim/swimmers/hinges.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>
#include <random>

#include "bead_vectors.hpp"
#include "beadswim/swimmers/swimmer_forces.hpp"
#include "beadswim/swimmers/swimmer_matrices.hpp"

// Hinges that pass straight, of a swimmer whose two hinges bend in turn to both sides, as those of Purcell's
// swimmer. Lengths in bead radii.

namespace beadswim {
namespace {

constexpr double period = 8, amplitude = 0.9;

/// Returns four beads at rest on the x axis, tilted out of the axes of the frame, with two driven hinges.
SwimmerType two_hinges() {
  const Eigen::Matrix3d tilt = Eigen::AngleAxisd(0.7, Vec3(1, 2, -1).normalized()).toRotationMatrix();
  SwimmerType type;
  for (const double x : {-5.0, 0.0, 4.0, 10.0})
    type.beads.push_back({{.radius = 1, .density = 1}, tilt * Vec3(x, 0, 0)});
  type.bonds = {{{30, 5, 0}, {0, 1}}, {{30, 4, 0}, {1, 2}}, {{30, 6, 0}, {2, 3}}};
  const Vec3 normal = tilt.col(2);
  type.angles = {{.beads = {0, 1, 2}, .stiffness = 7, .normal = normal},
                 {.beads = {1, 2, 3}, .stiffness = 5, .normal = normal}};
  type.driving = {
      .period = period,
      .angles = {{.angle = 0, .harmonics = {{.amplitude = amplitude}}},
                 {.angle = 1, .harmonics = {{.amplitude = amplitude, .phase = std::numbers::pi / 2}}}}};
  return type;
}

BeadVectors at_rest(const SwimmerType& type) {
  return columns(rest_positions(type, Vec3::Zero(), Eigen::Matrix3d::Identity()));
}

/// Returns the beads at their rest angles at `time`, turned, moved and each displaced, also out of the plane.
BeadVectors displaced(const SwimmerType& type, double time, double size, std::mt19937& random) {
  BeadVectors beads = random_rotation(random) * at_rest(at_rest_angles(type, time));
  beads.colwise() += Vec3(30, -20, 50);
  for (auto bead : beads.colwise()) bead += size * random_vector(random);
  return beads;
}

/// Returns K_A |theta m - rest n|^2/2, where m is the unit vector about which the second side is turned from
/// the first, and n the normal of the fitted shape.
double energy(const SwimmerType& type, double time, const BeadVectors& x) {
  const Eigen::Matrix3d turn = fitted_orientation(at_rest_angles(type, time), x, Eigen::Matrix3d::Identity());
  double sum = 0;
  for (std::size_t k = 0; k < type.angles.size(); ++k) {
    const auto& [beads, stiffness, rest, normal] = type.angles[k];
    const Vec3 first = x.col(beads[1]) - x.col(beads[0]), second = x.col(beads[2]) - x.col(beads[1]);
    const Eigen::AngleAxisd bend(Eigen::Quaterniond::FromTwoVectors(first, second));
    sum += stiffness / 2 *
           (bend.angle() * bend.axis() - rest_angle(type, k, time) * (turn * *normal)).squaredNorm();
  }
  return sum;
}

// Times at which hinge 1, hinge 2 and none is straight.
const std::array<double, 4> times{0, 1.1, period / 4, 5.3};

// Would catch a normal that the forces take as fixed in the box.
TEST(Hinges, HaveTheForcesOfTheirEnergy) {
  std::mt19937 random(1);
  const SwimmerType type = two_hinges();
  for (const double time : times) {
    const BeadVectors x = displaced(type, time, 0.4, random);
    const BeadVectors force = angle_forces(type, time, x);
    constexpr double h = 1e-5, truncation = 1e-8;
    for (int c = 0; c < x.size(); ++c) {
      BeadVectors ahead = x, behind = x;
      ahead.reshaped()[c] += h;
      behind.reshaped()[c] -= h;
      EXPECT_NEAR(force.reshaped()[c], -(energy(type, time, ahead) - energy(type, time, behind)) / (2 * h),
                  truncation)
          << "coordinate " << c << " at time " << time;
    }
  }
}

TEST(Hinges, ExertNoTotalForceOrTorqueOnBentTiltedShapes) {
  std::mt19937 random(2);
  const SwimmerType type = two_hinges();
  for (const double time : times) {
    const BeadVectors x = displaced(type, time, 0.4, random);
    const BeadVectors force = angle_forces(type, time, x);
    Vec3 torque = Vec3::Zero();
    for (int b = 0; b < x.cols(); ++b) torque += Vec3(x.col(b) - x.col(0)).cross(Vec3(force.col(b)));
    constexpr double roundoff = 1e-12;
    EXPECT_LT(force.rowwise().sum().norm(), roundoff);
    EXPECT_LT(torque.norm(), roundoff);
    EXPECT_GT(force.norm(), 0.1);
  }
}

TEST(Hinges, AreAtRestOnTheShapeOfTheirRestAngles) {
  const SwimmerType type = two_hinges();
  for (const double time : times) {
    const SwimmerType shaped = at_rest_angles(type, time);
    const BeadVectors x = at_rest(shaped);
    constexpr double roundoff = 1e-13;
    EXPECT_LT(angle_forces(type, time, x).norm(), roundoff);
    for (std::size_t k = 0; k < 2; ++k) {
      EXPECT_NEAR(angle_at_rest(shaped, type.angles[k]), rest_angle(type, k, time), roundoff);
      EXPECT_NEAR(angle_of(type, type.angles[k], time, x), rest_angle(type, k, time), roundoff);
    }
  }
}

// The stiffness neglects second derivatives times the strain, which is zero on the shape of the rest angles.
TEST(Hinges, HaveTheStiffnessOfTheirForces) {
  std::mt19937 random(3);
  SwimmerType type = two_hinges();
  for (const double time : times) {
    const BeadVectors x = displaced(type, time, 0, random);
    const Eigen::MatrixXd stiffness = own_stiffness<Eigen::Dynamic>(type, time, x);
    constexpr double h = 1e-5, truncation = 1e-7;
    for (int c = 0; c < x.size(); ++c) {
      BeadVectors ahead = x, behind = x;
      ahead.reshaped()[c] += h;
      behind.reshaped()[c] -= h;
      const Eigen::VectorXd slope =
          (own_forces<Eigen::Dynamic>(type, time, behind) - own_forces<Eigen::Dynamic>(type, time, ahead)) /
          (2 * h);
      EXPECT_LT((stiffness.col(c) - slope).norm(), truncation) << "coordinate " << c << " at time " << time;
    }
  }
}

// A hinge with the opposite normal and the opposite rest angle is the same one.
TEST(Hinges, BendToTheOtherSideUnderMirror) {
  std::mt19937 random(4);
  const SwimmerType type = two_hinges();
  SwimmerType mirrored = type;
  for (Angle& angle : mirrored.angles) angle.normal = -*angle.normal;
  for (AngleDrive& drive : mirrored.driving.angles) drive.harmonics[0].amplitude *= -1;
  for (const double time : times) {
    const BeadVectors x = displaced(type, time, 0.4, random);
    constexpr double roundoff = 1e-12;
    EXPECT_LT((angle_forces(type, time, x) - angle_forces(mirrored, time, x)).norm(), roundoff);
    // Half a period later, all hinges bend to the other side.
    const BeadVectors now = at_rest(at_rest_angles(type, time)),
                      later = at_rest(at_rest_angles(type, time + period / 2));
    const Vec3 side = type.angles[0].normal->cross(type.beads[3].at).normalized();
    EXPECT_LT((later - (now - 2 * side * side.transpose() * now)).norm(), roundoff);
  }
}

// Without drives, work of the beads is energy of the springs: the power of the drives is dU/dt at fixed
// beads.
TEST(Hinges, TakeTheirPowerFromTheDrives) {
  std::mt19937 random(5);
  const SwimmerType type = two_hinges();
  for (const double time : times) {
    BeadVectors x = at_rest(at_rest_angles(type, time - 0.3));  // behind the drives, in the plane
    x = random_rotation(random) * x;
    constexpr double h = 1e-5, truncation = 1e-7;
    const double rate = (energy(type, time + h, x) - energy(type, time - h, x)) / (2 * h);
    EXPECT_NEAR(power_of_drives(type, time, x, zero_vectors(type), Eigen::Matrix3d::Identity()), rate,
                truncation);
    EXPECT_GT(std::abs(rate), 0.1);
  }
}

}  // namespace
}  // namespace beadswim
