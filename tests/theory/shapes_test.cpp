#include <gtest/gtest.h>

#include <numbers>

#include "beadswim/collinear/oseen.hpp"
#include "beadswim/collinear/rotne_prager.hpp"
#include "beadswim/core/error.hpp"
#include "beadswim/scene/gallery.hpp"
#include "beadswim/theory/periodic_motion.hpp"
#include "beadswim/theory/shaped_swimmer.hpp"
#include "random_swimmers.hpp"
#include "shaped_line.hpp"

// The motion of swimmers of any shape, against the theory of three beads on a line, symmetries and limits.

namespace beadswim {
namespace {

constexpr double pi = std::numbers::pi;

TEST(SecondOrderMotionOfShapes, OfThreeBeadsOnALineIsThatOfTheLine) {
  RandomSwimmers random(0.1, 10);
  const Eigen::Matrix3d orientation = some_orientation();
  for (int n = 0; n < 12; ++n) {
    const CollinearSwimmer line = random.next();
    const bool by_oseen = n % 3 == 0;
    const PeriodicMotion expected =
        second_order_motion(line, rest_mobility(line, by_oseen ? oseen : rotne_prager));
    const ShapeMotion motion =
        second_order_motion(shaped(line, orientation), by_oseen ? oseen_pairs : rotne_prager_tensor);
    const double d1 = expected.stroke.amplitude[0], d2 = expected.stroke.amplitude[1];
    const double scale = d1 * d2 * line.angular_frequency() / (line.arm[0] + line.arm[1]);
    EXPECT_LT((motion.velocity_vector - expected.velocity * orientation.col(0)).norm(), 1e-7 * scale) << n;
    EXPECT_LT(motion.angular_velocity.norm() * line.arm[0], 1e-6 * scale) << n;
    EXPECT_NEAR(motion.power / mean_power(line, expected.stroke), 1, 1e-6) << n;
    for (int k = 0; k < 2; ++k) {
      EXPECT_NEAR(motion.stroke.amplitude[k] / expected.stroke.amplitude[k], 1, 1e-9);
      EXPECT_NEAR(std::remainder(motion.stroke.phase[k] - expected.stroke.phase[k], 2 * pi), 0, 1e-9);
      EXPECT_NEAR(motion.arm_changes[k], expected.arm_changes[k],
                  1e-6 * (d1 * d1 + d2 * d2) / line.arm[k] + 1e-15 * line.arm[k]);
    }
  }
}

TEST(FirstOrderMotionOfShapes, OfThreeBeadsOnALineIsThatOfTheLine) {
  RandomSwimmers random(0.1, 10);
  for (int n = 0; n < 12; ++n) {
    const CollinearSwimmer line = random.next();
    const LinearResponse expected = linear_response(line, rest_mobility(line, rotne_prager).value);
    const FirstOrderMotion motion = first_order_motion(shaped(line, some_orientation()), rotne_prager_tensor);
    for (int b = 0; b < 3; ++b)
      EXPECT_NEAR(motion.bead_speeds[b] / (line.angular_frequency() * std::abs(expected.displacement[b])), 1,
                  1e-9)
          << n;
    for (int k = 0; k < 2; ++k)
      EXPECT_NEAR(motion.stroke.amplitude[k] / std::abs(expected.arm[k]), 1, 1e-9) << n;
  }
}

// Stokes' law for a bead that one force drives on a circle and another one tows: catches the speeds along
// two axes being added.
TEST(FirstOrderMotionOfShapes, OfABeadIsStokesLaw) {
  constexpr double radius = 2, viscosity = 3, force = 5, towing = 7;
  SwimmerType type;
  type.beads = {{{radius, 1}, Vec3::Zero()}};
  type.driving = {.period = 11, .net_force = NetForce::allowed};
  type.driving.forces = {
      {.bead = 0, .direction = Vec3::UnitX(), .harmonics = {{.amplitude = force}}},
      {.bead = 0, .direction = Vec3::UnitY(), .harmonics = {{.amplitude = force, .phase = pi / 2}}},
      {.bead = 0, .direction = Vec3::UnitZ(), .constant = towing}};
  const FirstOrderMotion motion =
      first_order_motion({type, some_orientation(), viscosity}, rotne_prager_tensor);
  EXPECT_NEAR(motion.bead_speeds.at(0), (force + towing) / (6 * pi * viscosity * radius), 1e-12);
}

PeriodicMotion motion_of_line(const CollinearSwimmer& line) {
  const MobilityFunction mobility = [&](const LinePositions& x) {
    return pairwise_mobility(rotne_prager, line.radius, x, line.viscosity);
  };
  return periodic_motion(line, rest_positions(line), mobility);
}

// A velocity of 1e-7 of the speed of the beads, whose error is that of a motion that is nearly periodic.
TEST(PeriodicMotionOfShapes, StatesAnUpperBoundOfItsError) {
  CollinearSwimmer line = paper_swimmer(2000);
  line.radius = {1, 2, 3};
  line.arm = {640, 960};
  line.stiffness = {0.01, 0.01};
  line.amplitude = {0.5, 0.7};
  line.phase = 0.7;
  const double expected = motion_of_line(line).velocity;
  const Eigen::Matrix3d orientation = some_orientation();
  const ShapeMotion motion = periodic_motion(shaped(line, orientation), rotne_prager_tensor);
  EXPECT_LT((motion.velocity_vector - expected * orientation.col(0)).norm(), motion.numerical_error);
  EXPECT_LT(motion.numerical_error, 1e-4 * expected);
}

TEST(PeriodicMotionOfShapes, OfThreeBeadsOnALineIsThatOfTheLine) {
  const Eigen::Matrix3d orientation = some_orientation();
  CollinearSwimmer line = paper_swimmer(2000);
  line.radius = {4, 3, 5};
  line.stiffness = {0.0347, 0.05};
  line.damping = {0, 2};
  line.amplitude = {0.3, 0.2};
  line.phase = 1.1;
  const PeriodicMotion expected = motion_of_line(line);
  const ShapeMotion motion = periodic_motion(shaped(line, orientation), rotne_prager_tensor);
  EXPECT_LT((motion.velocity_vector - expected.velocity * orientation.col(0)).norm(),
            1e-7 * expected.velocity);
  EXPECT_LT(motion.numerical_error, 1e-6 * expected.velocity);
  EXPECT_NEAR(motion.power / mean_power(line, expected.stroke), 1, 1e-7);
  for (int k = 0; k < 2; ++k) {
    EXPECT_NEAR(motion.stroke.amplitude[k] / expected.stroke.amplitude[k], 1, 1e-8);
    EXPECT_NEAR((line.arm[k] + motion.arm_changes[k]) / (line.arm[k] + expected.arm_changes[k]), 1, 1e-9);
  }
  EXPECT_NEAR(motion.smallest_gap / expected.smallest_gap, 1, 1e-2);  // sampled at other times
}

// Driving forces along x turn a swimmer that begins at an angle to x until it is parallel to them. Its
// velocity is then that of the line. Would catch a projection on the axis at the start.
TEST(PeriodicMotionOfShapes, OfALineThatItsDrivesTurnIsThatOfTheLine) {
  CollinearSwimmer line = paper_swimmer(2000);
  line.amplitude = {0.3, 0.3};
  ShapedSwimmer swimmer = shaped(line, Eigen::AngleAxisd(0.4, Vec3::UnitZ()).toRotationMatrix());
  swimmer.type.driving.frame = DrivingFrame::lab;
  const ShapeMotion motion = periodic_motion(swimmer, rotne_prager_tensor);
  EXPECT_NEAR(motion.turn, 0.4, 1e-6);
  EXPECT_NEAR(motion.velocity / motion_of_line(line).velocity, 1, 1e-6);
}

const Fluid fluid{.density = 1, .kinematic_viscosity = 1.0 / 3};

ShapedSwimmer of_gallery(const auto& parameters) {
  return {swimmer_type(parameters, fluid), some_orientation(), fluid.dynamic_viscosity()};
}

TEST(PeriodicMotionOfShapes, OfADumbbellIsNone) {
  Dumbbell dumbbell;
  dumbbell.radius = {4, 2};
  const ShapeMotion motion = periodic_motion(of_gallery(dumbbell), rotne_prager_tensor);
  EXPECT_LT(motion.velocity_vector.norm() * dumbbell.period, 1e-10 * motion.stroke.amplitude[0]);
  EXPECT_LT(motion.angular_velocity.norm() * dumbbell.period, 1e-12);
}

TEST(PeriodicMotionOfShapes, OfATriangleIsARotation) {
  const ShapeMotion motion = periodic_motion(of_gallery(Triangle{}), rotne_prager_tensor);
  const double turn = motion.angular_velocity.dot(some_orientation().col(2)) * 4800;
  EXPECT_GT(turn, 0.1);
  EXPECT_NEAR(motion.angular_velocity.norm() * 4800, turn, 1e-9);
  EXPECT_LT(motion.velocity_vector.norm() * 4800, 1e-9);
}

// Would catch a velocity that depends on the phase of the drives at the start of a cycle, and rotations that
// are multiples of the time steps: two beads that a couple rotates by Omega = 2 F (mu_self - mu_across)/d.
TEST(PeriodicMotionOfShapes, HasTheSameVelocityAtEachPhase) {
  Triangle circling;
  circling.phase = pi / 2;
  ShapedSwimmer swimmer = of_gallery(circling);
  const ShapeMotion first = periodic_motion(swimmer, rotne_prager_tensor);
  EXPECT_GT(first.velocity_vector.norm() * 4800, 0.01);
  for (const double offset : {1.0, 2.5, 4.0}) {
    swimmer.type.driving.phase_offset = offset;
    const ShapeMotion motion = periodic_motion(swimmer, rotne_prager_tensor);
    EXPECT_NEAR(motion.velocity_vector.norm() / first.velocity_vector.norm(), 1, 1e-6) << offset;
    EXPECT_LT((motion.angular_velocity - first.angular_velocity).norm() * 4800, 1e-9) << offset;
  }
}

TEST(PeriodicMotionOfShapes, OfACoupleIsARotationAtAnyRate) {
  constexpr double eta = 1.0 / 3, a = 4, d = 20, period = 1000;
  SwimmerType type;
  for (const double x : {-d / 2, d / 2}) type.beads.push_back({{.radius = a, .density = 1}, Vec3(x, 0, 0)});
  type.bonds = {{{100, d, 0}, {0, 1}}};
  type.driving.period = period;
  type.driving.frame = DrivingFrame::body;
  const double across = (1 + 2 * a * a / (3 * d * d)) / (8 * pi * eta * d);
  for (const double force : {0.015, 1.5, 15.0}) {
    type.driving.forces.clear();
    for (const int bead : {0, 1})
      type.driving.forces.push_back(
          {.bead = bead, .direction = Vec3::UnitY(), .constant = bead == 0 ? -force : force});
    const Vec3 expected(0, 0, 2 * force * (self_mobility(a, eta) - across) / d);
    const ShapedSwimmer swimmer{type, Eigen::Matrix3d::Identity(), eta};
    const ShapeMotion motion = periodic_motion(swimmer, rotne_prager_tensor);
    EXPECT_LT((motion.angular_velocity - expected).norm(), 1e-7 * expected.norm()) << force;
    EXPECT_LT(motion.velocity_vector.norm() * period, 1e-9);
  }
}

// A couple that turns two beads up to hundreds of times in a period: where even the finest steps are too
// long, the motion is marked as unresolved, and its error is not stated as zero.
TEST(PeriodicMotionOfShapes, IsMarkedWhereTheFinestStepsAreTooLong) {
  SwimmerType type;
  for (const double x : {-10, 10}) type.beads.push_back({{.radius = 4, .density = 1}, Vec3(x, 0, 0)});
  type.bonds = {{{100, 20, 0}, {0, 1}}};
  type.driving.period = 1000;
  type.driving.frame = DrivingFrame::body;
  int unresolved = 0;
  for (const double force : {40.0, 80.0, 120.0, 160.0, 200.0, 240.0}) {
    type.driving.forces.clear();
    for (const int bead : {0, 1})
      type.driving.forces.push_back(
          {.bead = bead, .direction = Vec3::UnitY(), .constant = bead == 0 ? -force : force});
    const ShapedSwimmer swimmer{type, Eigen::Matrix3d::Identity(), 1.0 / 3};
    try {
      const ShapeMotion motion = periodic_motion(swimmer, rotne_prager_tensor);
      unresolved += motion.is_resolved ? 0 : 1;
      EXPECT_GT(motion.numerical_error, 0) << force;
    } catch (const InputError&) {  // no step count has a solution
    }
  }
  EXPECT_GT(unresolved, 0);
}

// Equal forces along the circle through the corners spin a triangle several times in a period, as a rigid
// body.
TEST(PeriodicMotionOfShapes, SpinsManyTimesInAPeriod) {
  Triangle parameters;
  parameters.amplitude = {0};
  SwimmerType type = swimmer_type(parameters, fluid);
  type.driving.bonds.clear();
  type.driving.frame = DrivingFrame::body;
  const double eta = fluid.dynamic_viscosity();
  std::vector<Vec3> along;
  for (const BeadAtRest& bead : type.beads) along.push_back(Vec3::UnitZ().cross(bead.at).normalized());
  double mobility = self_mobility(4, eta);  // velocity of a bead along the circle, per force on each bead
  for (int b : {1, 2}) {
    const Vec3 d = type.beads[b].at - type.beads[0].at;
    mobility += along[0].dot(rotne_prager_tensor(4, 4, d.norm(), eta).apply(d, d.norm(), along[b]));
  }
  const double force = 3 * 2 * pi / 4800 * type.beads[0].at.norm() / mobility;
  for (int b = 0; b < 3; ++b)
    type.driving.forces.push_back({.bead = b, .direction = along[b], .constant = force});
  const ShapeMotion motion = periodic_motion({type, some_orientation(), eta}, rotne_prager_tensor);
  EXPECT_NEAR(motion.angular_velocity.dot(some_orientation().col(2)) * 4800 / (6 * pi), 1, 1e-9);
  EXPECT_LT(motion.velocity_vector.norm() * 4800, 1e-9);
}

// An angular spring against the bonds of a triangle: the second order does not know its stiffness, and the
// motion at finite amplitude does not need it.
TEST(PeriodicMotionOfShapes, ExistsWithSpringsThatWorkAgainstOneAnother) {
  ShapedSwimmer swimmer = of_gallery(Triangle{});
  swimmer.type.angles = {{.beads = {0, 1, 2}, .stiffness = 3000, .rest = 1.5}};
  EXPECT_THROW(second_order_motion(swimmer, rotne_prager_tensor), InputError);
  const ShapeMotion motion = periodic_motion(swimmer, rotne_prager_tensor);
  EXPECT_GT(motion.angular_velocity.norm() * 4800, 0.05);
  EXPECT_LT(motion.numerical_error * 4800, 1e-6);
}

/// Returns the largest relative difference of velocity and angular velocity between second order and finite
/// amplitude, for drives multiplied by `factor`.
double beyond_second_order(ShapedSwimmer swimmer, double factor) {
  for_each_harmonic(swimmer.type.driving, [&](Harmonic& harmonic) { harmonic.amplitude *= factor; });
  const ShapeMotion small = second_order_motion(swimmer, rotne_prager_tensor);
  const ShapeMotion finite = periodic_motion(swimmer, rotne_prager_tensor);
  const auto relative = [](const Vec3& a, const Vec3& b) {
    return b.norm() > 0 ? (a - b).norm() / b.norm() : 0;
  };
  return std::max(small.velocity_vector.norm() * 1e4 > 1e-3 * factor * factor
                      ? relative(finite.velocity_vector, small.velocity_vector)
                      : 0,
                  small.angular_velocity.norm() * 1e4 > 1e-3 * factor * factor
                      ? relative(finite.angular_velocity, small.angular_velocity)
                      : 0);
}

TEST(SecondOrderMotionOfShapes, IsTheLimitOfFiniteAmplitude) {
  Triangle circling;
  circling.amplitude = {3, 2, 1};
  circling.phase = 1;
  const std::vector<ShapedSwimmer> swimmers{of_gallery(Triangle{}), of_gallery(circling),
                                            of_gallery(PrescribedThreeBead{}), of_gallery(PurcellChain{}),
                                            of_gallery(Flagellum{})};
  for (std::size_t n = 0; n < swimmers.size(); ++n) {
    const double large = beyond_second_order(swimmers[n], 0.2), small = beyond_second_order(swimmers[n], 0.1);
    EXPECT_NEAR(large / small, 4, 0.4) << n;
    EXPECT_LT(small, 0.05) << n;
  }
}

// Place and orientation over a wall are those at time 0 in the motion at finite amplitude, their means in
// that of second order: the difference is of third order in the drives.
TEST(SecondOrderMotionOfShapes, IsTheLimitOfFiniteAmplitudeOverAWall) {
  const auto difference = [](double factor) {
    Triangle triangle;
    triangle.amplitude = {3 * factor, 2 * factor, factor};
    ShapedSwimmer swimmer = of_gallery(triangle);
    swimmer.domain.half_space = HalfSpace{};
    swimmer.place = Vec3(0, 0, 20);
    const ShapeMotion small = second_order_motion(swimmer, rotne_prager_tensor);
    const ShapeMotion finite = periodic_motion(swimmer, rotne_prager_tensor);
    EXPECT_NEAR(small.angular_velocity.norm() / finite.angular_velocity.norm(), 1, 0.2 * factor);
    return std::max((small.velocity_vector - finite.velocity_vector).norm(),
                    (small.angular_velocity - finite.angular_velocity).norm() * 10);
  };
  EXPECT_NEAR(difference(0.2) / difference(0.1), 8, 1);
}

// A steady couple that turns with the swimmer rotates it at first order in the drives. Its product with the
// oscillation changes V at second order; the difference from finite amplitude is of third order. The power of
// the couple is its torque times the rotation.
TEST(SecondOrderMotionOfShapes, IsTheLimitOfFiniteAmplitudeUnderASteadyCouple) {
  const auto difference = [](double factor) {
    Triangle triangle;
    triangle.amplitude = {3 * factor, 2 * factor, factor};
    triangle.phase = 1;
    ShapedSwimmer swimmer = of_gallery(triangle);
    swimmer.type.driving.frame = DrivingFrame::body;
    for (const int bead : {0, 1}) {
      const double force = (bead == 0 ? -1 : 1) * 0.05 * factor;
      swimmer.type.driving.forces.push_back(
          {.bead = bead, .direction = Vec3::UnitY(), .constant = force, .harmonics = {{.amplitude = force}}});
    }
    const ShapeMotion small = second_order_motion(swimmer, rotne_prager_tensor);
    const ShapeMotion finite = periodic_motion(swimmer, rotne_prager_tensor);
    EXPECT_NEAR(small.power / finite.power, 1, 0.1 * factor);
    return std::max((small.velocity_vector - finite.velocity_vector).norm(),
                    (small.angular_velocity - finite.angular_velocity).norm() * 10);
  };
  EXPECT_NEAR(difference(0.2) / difference(0.1), 8, 1);
}

}  // namespace
}  // namespace beadswim
