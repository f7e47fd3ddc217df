#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "beadswim/core/error.hpp"
#include "beadswim/theory/box_mobility.hpp"
#include "scenes.hpp"

namespace beadswim {
namespace {

double second_order_velocity(const Question& question) {
  return predicted("rpy-box-perturbation", question).velocity;
}

double over_unbounded(const CollinearSwimmer& swimmer, const Box& box) {
  return second_order_velocity(ask_in_box(swimmer, box)) /
         predicted("rpy-perturbation", ask(swimmer)).velocity;
}

// ---- Against an independent calculation

// Beenakker's sum by separate code, to its printed digits: periodic cubes, long and narrow boxes, closed
// ones.
TEST(RpyBox, VelocityIsThatOfAnIndependentEwaldSum) {
  const struct {
    Box box;
    double ratio, last_digit;
  } rows[] = {{periodic_box(60, 60, 60), 1.3228, 5e-5},    {periodic_box(80, 80, 80), 1.0745, 5e-5},
              {periodic_box(100, 100, 100), 1.0287, 5e-5}, {periodic_box(150, 150, 150), 1.0072, 5e-5},
              {periodic_box(200, 200, 200), 1.0030, 5e-5}, {periodic_box(120, 80, 80), 0.998, 5e-4},
              {periodic_box(100, 40, 40), 0.768, 5e-4},    {walled_box(200, 120, 120), 1.00297, 5e-6},
              {walled_box(160, 80, 80), 0.99226, 5e-6},    {walled_box(1200, 800, 800), 1.00003, 5e-6}};
  for (const auto& row : rows) {
    EXPECT_NEAR(over_unbounded(paper_swimmer(4800), row.box), row.ratio, row.last_digit)
        << row.box.lengths.transpose();
  }
}

// 128 x 80 x 80 by another independent sum, strokes included.
TEST(RpyBox, StrokeIsThatOfAnIndependentEwaldSum) {
  constexpr double last_digit = 0.51;
  const struct {
    double period, d1, d2, sine, velocity;
  } rows[] = {{2000, 12.62441, 17.09949, 0.79546, 1.741890e-3},
              {4800, 17.86553, 26.64859, 0.94168, 1.894908e-3}};
  for (const auto& row : rows) {
    const Prediction p =
        predicted("rpy-box-perturbation", ask_in_box(paper_swimmer(row.period), periodic_box(128, 80, 80)));
    EXPECT_NEAR(p.stroke.amplitude[0], row.d1, last_digit * 1e-5);
    EXPECT_NEAR(p.stroke.amplitude[1], row.d2, last_digit * 1e-5);
    EXPECT_NEAR(p.sin_phase_shift, row.sine, last_digit * 1e-5);
    EXPECT_NEAR(p.velocity, row.velocity, last_digit * 1e-9);
  }
}

// ---- Mirrors

class BoxMethod : public testing::TestWithParam<std::string> {
 protected:
  Prediction in_box(const Box& box, const std::array<double, 3>& middle) const {
    return predicted(GetParam(), ask_in_box(with_amplitude(unequal_swimmer(), 0.2), box, middle));
  }
  void expect_same(const Prediction& a, const Prediction& b) const {
    constexpr double roundoff = 1e-9;
    EXPECT_NEAR(a.velocity / b.velocity, 1, roundoff);
    EXPECT_NEAR(a.stroke.amplitude[0] / b.stroke.amplitude[0], 1, roundoff);
    EXPECT_NEAR(a.stroke.amplitude[1] / b.stroke.amplitude[1], 1, roundoff);
    EXPECT_NEAR(a.sin_phase_shift, b.sin_phase_shift, roundoff);
  }
};

// Midway between side walls the mirror copies lie where the images of a periodic box of the same width do.
TEST_P(BoxMethod, MidwayBetweenSideWallsIsPeriodic) {
  const Box walls{.lengths = {120, 70, 50},
                  .boundary = {Boundary::periodic, Boundary::free_slip, Boundary::free_slip}};
  expect_same(in_box(walls, {10, 35, 25}), in_box(periodic_box(120, 70, 50), {77, 3, 60}));
}

// Which side wall is which, and which of the two widths comes first, is nothing to a swimmer.
TEST_P(BoxMethod, SideAxesMayBeSwappedAndReflected) {
  const Prediction p = in_box(
      {.lengths = {120, 70, 50}, .boundary = {Boundary::free_slip, Boundary::free_slip, Boundary::periodic}},
      {50, 20, 3});
  expect_same(p, in_box({.lengths = {120, 50, 70},
                         .boundary = {Boundary::free_slip, Boundary::periodic, Boundary::free_slip}},
                        {50, 40, 20}));
  expect_same(p, in_box({.lengths = {120, 70, 50},
                         .boundary = {Boundary::free_slip, Boundary::free_slip, Boundary::periodic}},
                        {50, 50, 3}));
}

TEST_P(BoxMethod, PlaceAlongPeriodicAxisDoesNotMatter) {
  const Box box = periodic_box(120, 70, 50);
  expect_same(in_box(box, {7, 35, 25}), in_box(box, {111, 1, 0}));
}

// With walls across the axis it does, and the mirrored swimmer at the mirrored place moves the other way.
TEST_P(BoxMethod, WallsAcrossTheAxisFeelPlaceAndMirror) {
  const Box box{.lengths = {110, 90, 80},
                .boundary = {Boundary::free_slip, Boundary::periodic, Boundary::periodic}};
  const Prediction near = in_box(box, {35, 45, 40}), far = in_box(box, {55, 45, 40});
  EXPECT_GT(std::abs(near.velocity / far.velocity - 1), 1e-3);
  const CollinearSwimmer mirror_image = mirrored(with_amplitude(unequal_swimmer(), 0.2));
  const Prediction there = predicted(GetParam(), ask_in_box(mirror_image, box, {110 - 35, 45, 40}));
  constexpr double roundoff = 1e-9;
  EXPECT_NEAR(there.velocity / near.velocity, -1, roundoff);
}

INSTANTIATE_TEST_SUITE_P(All, BoxMethod,
                         testing::Values("rpy-box-perturbation", "rpy-box-ode", "unsteady-response",
                                         "inertia-corrected"),
                         test_name);

// ---- Finite amplitude

TEST(RpyBox, OdeTendsToPerturbationAsAmplitudeSquared) {
  const BoxPlace places[] = {{periodic_box(100, 60, 50), {50, 30, 25}},
                             {walled_box(100, 60, 50), {40, 20, 30}}};
  for (const BoxPlace& place : places) {
    const auto deviation = [&](double amplitude) {
      const Question question =
          ask_in_box(with_amplitude(unequal_swimmer(), amplitude), place.box, place.middle_bead);
      return predicted("rpy-box-ode", question).velocity / second_order_velocity(question) - 1;
    };
    constexpr double slope_tolerance = 0.02;
    EXPECT_NEAR(std::log2(deviation(0.04) / deviation(0.02)), 2, slope_tolerance);
    EXPECT_NEAR(std::log2(deviation(0.02) / deviation(0.01)), 2, slope_tolerance);
    EXPECT_LT(std::abs(deviation(0.01)), 5e-5);
  }
}

// ---- Refusals

std::string obstacle(const std::string& method, const CollinearSwimmer& swimmer, const Box& box,
                     const std::array<double, 3>& middle) {
  return obstacle(find_method(method), ask_in_box(swimmer, box, middle));
}

TEST(RpyBox, RefusesUnboundedLayouts) {
  for (const char* method : {"rpy-box-perturbation", "rpy-box-ode"}) {
    EXPECT_THAT(obstacle(find_method(method), ask(paper_swimmer(2000))), testing::HasSubstr("unbounded"))
        << method;
    EXPECT_THROW(predicted(method, ask(paper_swimmer(2000))), InputError);
  }
}

TEST(BoxMethods, RefuseImagesThatOverlap) {
  using testing::HasSubstr;
  const CollinearSwimmer swimmer = paper_swimmer(2000);  // radius 4, from -24 to 24 about its middle
  const Box x_walls{.lengths = {100, 60, 60},
                    .boundary = {Boundary::free_slip, Boundary::periodic, Boundary::periodic}};
  const Box y_walls{.lengths = {100, 60, 60},
                    .boundary = {Boundary::periodic, Boundary::free_slip, Boundary::periodic}};
  const Box z_walls{.lengths = {100, 60, 60},
                    .boundary = {Boundary::periodic, Boundary::periodic, Boundary::free_slip}};
  for (const char* method :
       {"rpy-box-perturbation", "rpy-box-ode", "unsteady-response", "inertia-corrected"}) {
    SCOPED_TRACE(method);
    EXPECT_THAT(obstacle(method, swimmer, periodic_box(47.9, 60, 60), {}), HasSubstr("overlap images"));
    EXPECT_EQ(obstacle(method, swimmer, periodic_box(48.1, 60, 60), {}), "");
    EXPECT_THAT(obstacle(method, swimmer, periodic_box(100, 7.9, 60), {}), HasSubstr("overlap images"));
    EXPECT_THAT(obstacle(method, swimmer, periodic_box(100, 60, 7.9), {}), HasSubstr("overlap images"));
    EXPECT_EQ(obstacle(method, swimmer, periodic_box(100, 8.1, 8.1), {}), "");
    EXPECT_THAT(obstacle(method, swimmer, x_walls, {23.9, 30, 30}), HasSubstr("overlap images"));
    EXPECT_THAT(obstacle(method, swimmer, x_walls, {76.1, 30, 30}), HasSubstr("overlap images"));
    EXPECT_EQ(obstacle(method, swimmer, x_walls, {24.1, 30, 30}), "");
    EXPECT_THAT(obstacle(method, swimmer, y_walls, {50, 3.9, 30}), HasSubstr("overlap images"));
    EXPECT_THAT(obstacle(method, swimmer, y_walls, {50, 56.1, 30}), HasSubstr("overlap images"));
    EXPECT_THAT(obstacle(method, swimmer, z_walls, {50, 30, 3.9}), HasSubstr("overlap images"));
    EXPECT_EQ(obstacle(method, swimmer, z_walls, {50, 30, 4.1}), "");
  }
}

// A box shorter than the swimmer lets it reach into its own images: fine as long as nothing touches.
TEST(BoxMethods, SeeOverlapWithAnyImage) {
  CollinearSwimmer swimmer = paper_swimmer(2000);
  swimmer.arm = {30, 30};
  for (const char* method : {"rpy-box-perturbation", "unsteady-response"}) {
    EXPECT_EQ(obstacle(method, swimmer, periodic_box(45, 60, 60), {}), "") << "beads at 0, 30 and 15 of 45";
    EXPECT_THAT(obstacle(method, swimmer, periodic_box(31, 60, 60), {}),
                testing::HasSubstr("overlap images"));
    EXPECT_THAT(obstacle(method, swimmer, periodic_box(60, 60, 60), {}),
                testing::HasSubstr("overlap images"));
    EXPECT_THAT(obstacle(method, swimmer, periodic_box(7.9, 60, 60), {}),
                testing::HasSubstr("overlap images"));
  }
}

TEST(BoxMethods, PassOnWhyABoxCannotBeTreated) {
  Question question = ask(paper_swimmer(2000));
  question.surroundings.obstacle = "its box holds 8 swimmers";
  for (const char* method : {"rpy-box-perturbation", "rpy-box-ode"})
    EXPECT_EQ(obstacle(find_method(method), question), question.surroundings.obstacle);
}

}  // namespace
}  // namespace beadswim
