#include "beadswim/collinear/line_flow.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "beadswim/collinear/pair_mobility.hpp"
#include "beadswim/collinear/rotne_prager.hpp"
#include "beadswim/core/error.hpp"

namespace beadswim {
namespace {

constexpr double eta = 1.0 / 3;  // [mass/(length time)]

TEST(LineFlow, IsRotnePragerInUnboundedFluid) {
  constexpr double roundoff = 1e-15;
  const LineFlow flow(eta);
  for (const double receiver : {27.0, -3.0}) {
    const SteadyFlow pair = flow.steady(receiver, 12);
    const PairMobility law = rotne_prager(4, 3, std::abs(receiver - 12), eta);
    const double sign = receiver > 12 ? 1 : -1;
    EXPECT_NEAR(pair.oseen.value + 25 * pair.laplacian.value, law.value, roundoff);
    EXPECT_NEAR(pair.oseen.by_receiver + 25 * pair.laplacian.by_receiver, sign * law.slope, roundoff);
    EXPECT_NEAR(pair.oseen.by_source + 25 * pair.laplacian.by_source, -sign * law.slope, roundoff);
  }
  EXPECT_EQ(flow.steady_images(5).oseen.value, 0);
}

TEST(LineFlow, DoesNotCrossAFreeSlipWall) {
  const Box box{.lengths = {90, 60, 50},
                .boundary = {Boundary::free_slip, Boundary::free_slip, Boundary::periodic}};
  const LineFlow flow(eta, box, 20, 10);
  const double near = 1e-9;
  constexpr double slope_over_near_wall = 1e-10;
  for (const double place : {near, 90 - near}) {
    EXPECT_NEAR(flow.steady(place, 30).oseen.value, 0, slope_over_near_wall);
    EXPECT_NEAR(flow.steady(place, 30).laplacian.value, 0, slope_over_near_wall);
  }
  EXPECT_GT(flow.steady(45, 30).oseen.value, 1e-3);
}

TEST(LineFlow, DerivativesByPlacesAreDerivatives) {
  const LineFlow flow(
      eta,
      {.lengths = {90, 60, 50}, .boundary = {Boundary::free_slip, Boundary::free_slip, Boundary::periodic}},
      20, 10);
  const double h = 1e-3, receiver = 70, source = 25;
  const SteadyFlow here = flow.steady(receiver, source);
  const double by_receiver =
      (flow.steady(receiver + h, source).oseen.value - flow.steady(receiver - h, source).oseen.value) /
      (2 * h);
  const double by_source =
      (flow.steady(receiver, source + h).oseen.value - flow.steady(receiver, source - h).oseen.value) /
      (2 * h);
  const double by_place =
      (flow.steady_images(source + h).oseen.value - flow.steady_images(source - h).oseen.value) / (2 * h);
  const SteadyFlow images = flow.steady_images(source);
  constexpr double truncation = 1e-7;  // of order (h/distance of walls and beads)^2, relative
  EXPECT_NEAR(by_receiver / here.oseen.by_receiver, 1, truncation);
  EXPECT_NEAR(by_source / here.oseen.by_source, 1, truncation);
  EXPECT_NEAR(by_place / (images.oseen.by_receiver + images.oseen.by_source), 1, truncation);
}

TEST(LineFlow, RefusesPlacesThatHaveNoFlow) {
  const Box walls{.lengths = {90, 60, 50},
                  .boundary = {Boundary::free_slip, Boundary::free_slip, Boundary::periodic}};
  EXPECT_THROW(LineFlow(eta, walls, 60, 10), InputError);
  EXPECT_THROW(LineFlow(eta, {.lengths = {90, 0, 50}, .boundary = {}}, 1, 1), InputError);
  EXPECT_THROW(LineFlow(eta).steady(3, 3), InputError);
  EXPECT_THROW(LineFlow(eta, walls, 20, 10).steady(90, 3), InputError);
  EXPECT_THROW(LineFlow(eta, {.lengths = {90, 60, 50}, .boundary = {}}, 1, 1).steady(93, 3), InputError);
}

}  // namespace
}  // namespace beadswim
