#include "beadswim/mobility/line_flow.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "beadswim/core/error.hpp"
#include "beadswim/mobility/pair_mobility.hpp"
#include "beadswim/mobility/rotne_prager.hpp"

namespace beadswim {
namespace {

constexpr double eta = 1.0 / 3;  // [mass/(length time)]
constexpr double pi = std::numbers::pi;

/// Returns the xx component of the Oseen tensor at the position (x, rho) relative to the force; 0 at the
/// position of the force.
double stokeslet(double x, double rho2) {
  const double r2 = x * x + rho2;
  if (r2 == 0) return 0;
  return (1 + x * x / r2) / (8 * pi * eta * std::sqrt(r2));
}

/// Returns the flow of a periodic row of forces along x, with reversed forces between them, at the distance
/// rho from the row. `direct`: distance along x from a force; `mirrored`: from a reversed force. The
/// remainder of the sum decreases as 1/n^2 and is extrapolated.
double alternating_row(double direct, double mirrored, double rho2, double period) {
  const auto sum_to = [&](int last) {
    double sum = 0;
    for (int n = -last; n <= last; ++n) {
      sum += stokeslet(direct + n * period, rho2) - stokeslet(mirrored + n * period, rho2);
    }
    return sum;
  };
  const int n = 400;
  const auto n2 = [](double last) { return (last + 0.5) * (last + 0.5); };
  const double coarse = sum_to(n), fine = sum_to(2 * n);
  return (n2(2 * n) * fine - n2(n) * coarse) / (n2(2 * n) - n2(n));
}

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

// A line midway between mirrors has its copies one box length apart: as in a periodic box of that length.
TEST(LineFlow, MidwayBetweenSideWallsIsAsInAPeriodicBox) {
  constexpr double roundoff = 1e-15;
  const LineFlow walls(
      eta,
      {.lengths = {90, 60, 50}, .boundary = {Boundary::periodic, Boundary::free_slip, Boundary::free_slip}},
      30, 25);
  const LineFlow periodic(eta, {.lengths = {90, 60, 50}, .boundary = {}}, 3, 4);
  EXPECT_NEAR(walls.steady(50, 30).oseen.value, periodic.steady(50, 30).oseen.value, roundoff);
  EXPECT_NEAR(walls.steady(50, 30).laplacian.value, periodic.steady(50, 30).laplacian.value, roundoff);
  EXPECT_NEAR(walls.steady_images(30).oseen.value, periodic.steady_images(30).oseen.value, roundoff);
  EXPECT_NEAR(walls.steady_images(30).laplacian.value, periodic.steady_images(30).laplacian.value, roundoff);
}

// Mirrored copies summed one by one: rows along x, whose forces alternate, so that their flow dies out
// exponentially across. Catches a mirror of wrong sign or place.
TEST(LineFlow, InAClosedBoxIsTheSumOverMirrorCopies) {
  const double lx = 30, ly = 26, lz = 34, y = 7, z = 15;
  const LineFlow flow(
      eta,
      {.lengths = {lx, ly, lz}, .boundary = {Boundary::free_slip, Boundary::free_slip, Boundary::free_slip}},
      y, z);
  const double receiver = 21, source = 9;
  double pair = 0, images = 0;
  for (int m = -14; m <= 14; ++m) {
    for (int n = -14; n <= 14; ++n) {
      const double dy = m % 2 == 0 ? m * ly : (m + 1) * ly - 2 * y;
      const double dz = n % 2 == 0 ? n * lz : (n + 1) * lz - 2 * z;
      const double rho2 = dy * dy + dz * dz;
      if (rho2 > 81 * lx * lx) continue;  // exp(-2 pi 9 lx/(2 lx)) = 5e-13 of a row at hand
      pair += alternating_row(receiver - source, receiver + source, rho2, 2 * lx);
      images += alternating_row(0, 2 * source, rho2, 2 * lx);
    }
  }
  constexpr double truncation = 1e-8;
  EXPECT_NEAR(flow.steady_images(source).oseen.value / images, 1, truncation);
  EXPECT_NEAR(flow.steady(receiver, source).oseen.value / pair, 1, truncation);
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

TEST(LineFlow, IsReciprocal) {
  constexpr double roundoff = 1e-16;
  const LineFlow flow(
      eta,
      {.lengths = {90, 60, 50}, .boundary = {Boundary::free_slip, Boundary::free_slip, Boundary::periodic}},
      20, 10);
  const SteadyFlow there = flow.steady(65, 20), back = flow.steady(20, 65);
  EXPECT_NEAR(there.oseen.value, back.oseen.value, roundoff);
  EXPECT_NEAR(there.oseen.by_receiver, back.oseen.by_source, roundoff);
  EXPECT_NEAR(there.laplacian.by_source, back.laplacian.by_receiver, roundoff);
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
