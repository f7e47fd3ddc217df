#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numbers>

#include "beadswim/collinear/rotne_prager.hpp"
#include "beadswim/core/error.hpp"
#include "beadswim/mobility/wall_map.hpp"
#include "beadswim/scene/gallery.hpp"
#include "beadswim/theory/box_mobility.hpp"
#include "beadswim/theory/periodic_motion.hpp"
#include "shaped_line.hpp"

// Mobilities of shapes with force moments, and in boxes, against exact flows of spheres on a line, the
// Rotne-Prager mobility of a line in a box, and formulas for one sphere.

namespace beadswim {
namespace {

constexpr double pi = std::numbers::pi;

CollinearSwimmer line_with_arms(double arm_over_radius, double amplitude) {
  CollinearSwimmer line = paper_swimmer(4800);
  line.arm = {4 * arm_over_radius, 4 * arm_over_radius};
  line.amplitude = {amplitude, amplitude};
  return line;
}

double velocity_with_moments(const CollinearSwimmer& line, int order) {
  const ShapedSwimmer swimmer = shaped(line, some_orientation());
  return second_order_motion(swimmer, moment_mobility(swimmer, order)).velocity;
}

// The velocity of three beads on a line differs from that in exact Stokes flow as in the table of
// docs/method/force-moments.md. The difference between the orders 1 and 2 is an upper bound of the error of
// order 2.
TEST(MomentMobility, OfThreeBeadsOnALineTendsToExactStokesFlow) {
  struct Row {
    double arm, order_1, order_2;
  };
  for (const auto& [arm, order_1, order_2] :
       {Row{3, 0.034, 0.014}, Row{4, 0.014, 0.0031}, Row{5, 0.0056, 0.0008}, Row{8, 0.0006, 0.00003}}) {
    const CollinearSwimmer line = line_with_arms(arm, 0.05);
    const double exact = second_order_motion(line, exact_mobility(line, rest_positions(line))).velocity;
    const double first = velocity_with_moments(line, 1) / exact - 1,
                 second = velocity_with_moments(line, 2) / exact - 1;
    EXPECT_NEAR(first / order_1, 1, 0.25) << arm;
    EXPECT_NEAR(second / order_2, 1, 0.25) << arm;
    EXPECT_LT(std::abs(second), std::abs(first - second)) << arm;
  }
}

TEST(MomentMobility, AtFiniteAmplitudeIsThatOfTheLine) {
  const CollinearSwimmer line = line_with_arms(8, 0.3);
  const double exact = predict(find_method("multipole-ode"), ask(line)).velocity;
  const Prediction shape =
      predict(find_method("multipole-ode"), Question(shaped(line, some_orientation()), 1));
  EXPECT_NEAR(shape.velocity / exact, 1, 1e-4);
  EXPECT_LT(std::abs(shape.velocity / exact - 1), *shape.uncertainty);
}

// The stated uncertainty is at least the difference from exact Stokes flow at finite amplitude.
TEST(MethodsForShapes, StateUpperBoundsOfTheirErrorsForThreeBeadsOnALine) {
  for (const double arm : {3.5, 5.0, 8.0}) {
    const CollinearSwimmer line = line_with_arms(arm, 0.1);
    const double exact = predict(find_method("multipole-ode"), ask(line)).velocity;
    const Question question(shaped(line, some_orientation()), 1);
    for (const char* method : {"oseen-ode", "rpy-ode"}) {
      const Prediction prediction = predict(find_method(method), question);
      const double error = std::abs(prediction.velocity / exact - 1);
      EXPECT_LT(error, 1.05 * *prediction.uncertainty) << method << arm;
      EXPECT_GT(error, 0.5 * *prediction.uncertainty) << method << arm;
    }
  }
}

/// Returns one bead of radius 1 in fluid of viscosity 1/(6 pi), so that its mobility is 1.
ShapedSwimmer one_bead(const Vec3& place) {
  SwimmerType type;
  type.beads = {{{.radius = 1, .density = 1}, Vec3::Zero()}};
  return {
      .type = type, .orientation = Eigen::Matrix3d::Identity(), .viscosity = 1 / (6 * pi), .place = place};
}

// Hasimoto, J. Fluid Mech. 5 (1959) 317; Sangani & Acrivos, Int. J. Multiphase Flow 8 (1982) 343: mobility of
// a simple cubic array of spheres. The first correction is that of the point forces of all images.
TEST(MomentMobility, OfOneBeadInACubeIsThatOfACubicArray) {
  for (const double edge : {10.0, 20.0, 40.0}) {
    ShapedSwimmer bead = one_bead(Vec3(1, 2, 3));
    bead.domain.box = Box{.lengths = Vec3::Constant(edge)};
    const double c = 4 * pi / 3 / std::pow(edge, 3);
    const double expected = 1 - 2.837297 / edge + c - 1.5593 * c * c;
    const Eigen::MatrixXd mu = moment_mobility(bead, 2).matrix(BeadVectors::Zero(3, 1));
    EXPECT_NEAR(mu(0, 0), expected, 1e-6 / edge + 4 * std::pow(c, 8 / 3.0)) << edge;
    EXPECT_NEAR(mu(0, 1), 0, 1e-9);
  }
}

TEST(MomentMobility, OfOneBeadOverAWallTendsToTheExactOne) {
  for (const double height : {2.0, 3.0, 6.0}) {
    ShapedSwimmer bead = one_bead(Vec3(0, 0, height));
    bead.domain.half_space = HalfSpace{};
    const auto error = [&](int order) {
      const Eigen::MatrixXd mu = moment_mobility(bead, order).matrix(BeadVectors::Zero(3, 1));
      return std::abs(mu(2, 2) * drag_towards_wall(height) - 1);
    };
    EXPECT_LT(error(2), 0.4 * std::pow(height, -8)) << height;
    EXPECT_LT(error(2), error(1) / 2) << height;
  }
}

// The line's own method sums images along the line (line_flow.hpp), without mesh. In the middle between
// walls, images do not bend the swimmer.
TEST(MomentMobility, OfOrderZeroInABoxIsThatOfALineInTheBox) {
  const CollinearSwimmer line = line_with_arms(5, 0.05);
  for (const auto boundary : {Boundary::periodic, Boundary::free_slip}) {
    const Box box{.lengths = {90, 50, 60}, .boundary = {Boundary::periodic, boundary, Boundary::periodic}};
    ShapedSwimmer swimmer = shaped(line, Eigen::Matrix3d::Identity());
    swimmer.domain.box = box;
    swimmer.place = Vec3(45, 25, 30);
    const BoxPlace place{.box = box, .middle_bead = {45, 25, 30}};
    const LineFlow flow = box_line_flow(place, line.viscosity);
    const PeriodicMotion expected =
        second_order_motion(line, rotne_prager_mobility(flow, line, rest_positions(line, place)));
    const ShapeMotion motion = second_order_motion(swimmer, moment_mobility(swimmer, 0));
    EXPECT_NEAR(motion.velocity / expected.velocity, 1, 1e-6);
    for (int k = 0; k < 2; ++k)
      EXPECT_NEAR(motion.stroke.amplitude[k] / expected.stroke.amplitude[k], 1, 1e-8);
  }
}

// The images of a force-free swimmer fall off with the volume of the box: doubling its edges leaves an eighth
// of the change.
TEST(MethodsForShapes, InAWideBoxTendToOpenSpace) {
  Triangle triangle;
  triangle.amplitude = {3, 2, 1};
  triangle.phase = 1;
  const Fluid fluid{.density = 1, .kinematic_viscosity = 1.0 / 3};
  ShapedSwimmer swimmer{swimmer_type(triangle, fluid), Eigen::Matrix3d::Identity(),
                        fluid.dynamic_viscosity()};
  const Vec3 open = second_order_motion(swimmer, moment_mobility(swimmer, 2)).velocity_vector;
  const auto change = [&](double edge) {
    swimmer.domain.box = Box{.lengths = Vec3::Constant(edge)};
    swimmer.place = Vec3::Constant(edge / 2);
    return (second_order_motion(swimmer, moment_mobility(swimmer, 2)).velocity_vector - open).norm();
  };
  EXPECT_NEAR(change(200) / change(400), 8, 0.3);
  EXPECT_LT(change(200), 0.03 * open.norm());
}

TEST(MethodsForShapes, InABoxNeedOneAndForcesThatSumToZero) {
  const auto reason = [](const Question& question) {
    return obstacle(find_method("multipole-box-ode"), question);
  };
  Question question(shaped(line_with_arms(5, 0.1), some_orientation()), 1);
  EXPECT_THAT(reason(question), testing::HasSubstr("needs a box"));
  question.surroundings.box =
      BoxPlace{.box = {.lengths = {100, 100, 100}, .boundary = {}}, .middle_bead = {}};
  EXPECT_EQ(reason(question), "");
  question.surroundings = {.obstacle = "the driving forces do not sum to zero"};
  EXPECT_EQ(reason(question), question.surroundings.obstacle);
  EXPECT_THAT(reason(ask(line_with_arms(5, 0.1))), testing::HasSubstr("use rpy-box-ode"));
}

// Methods of second order treat no constant forces over a wall, and are not recommended there.
TEST(MethodsForShapes, AreRecommendedOnlyIfTheyTreatTheSwimmer) {
  ShapedSwimmer towed = one_bead(Vec3(0, 0, 3));
  towed.type.driving.period = 1;
  towed.type.driving.forces = {{.bead = 0, .direction = Vec3::UnitX(), .constant = 1}};
  towed.domain.half_space = HalfSpace{};
  try {
    predict(find_method("inertia-corrected"), Question(towed, 1));
    FAIL();
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("methods for this swimmer are oseen-ode, rpy-ode"));
    EXPECT_THAT(error.what(), testing::Not(testing::HasSubstr("-perturbation")));
  }
}

}  // namespace
}  // namespace beadswim
