#include "beadswim/collinear/periodic_stokes.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "beadswim/collinear/pair_mobility.hpp"

namespace beadswim {
namespace {

constexpr double eta = 1.0 / 3;  // [mass/(length time)]

/// Returns the flow at (d, y, z) of a periodic lattice of forces at the origin: the contribution of mirror
/// images at y and z.
SteadyLine off_the_line(double d, double y, double z, const Vec3& periods) {
  const auto with_copies = [&](double at_y, double at_z) {
    PeriodicLine line = periodic_line({.lengths = periods, .boundary = {}}, 0, 0);
    line.y.mirror = at_y;
    line.z.mirror = at_z;
    return PeriodicStokes(eta, line).at(d);
  };
  SteadyLine flow = with_copies(y, z);
  const SteadyLine axis = with_copies(0, 0), only_y = with_copies(y, 0), only_z = with_copies(0, z);
  for (const auto part : {&SteadyLine::oseen, &SteadyLine::laplacian}) {
    flow.*part += -1 * (only_y.*part);
    flow.*part += -1 * (only_z.*part);
    flow.*part += axis.*part;
  }
  return flow;
}

// The splitting is an arbitrary number: a missing or doubled piece of either sum depends on it.
TEST(PeriodicStokes, DoesNotDependOnSplitting) {
  PeriodicLine line = periodic_line(
      {.lengths = {128, 80, 96}, .boundary = {Boundary::periodic, Boundary::free_slip, Boundary::free_slip}},
      31, 40);
  const double balanced = line.splitting, unit = self_mobility(4, eta);
  const PeriodicStokes reference(eta, line);
  for (const double ratio : {0.5, 1.5, 2.5}) {
    line.splitting = ratio * balanced;
    const PeriodicStokes other(eta, line);
    constexpr double roundoff = 1e-13;  // of a bead's own mobility, a = 4
    for (const double d : {9.0, 40.0, 70.0}) {
      EXPECT_NEAR(other.at(d).oseen.value, reference.at(d).oseen.value, roundoff * unit);
      EXPECT_NEAR(other.at(d).oseen.slope, reference.at(d).oseen.slope, roundoff * unit);
      EXPECT_NEAR(other.at(d).laplacian.value, reference.at(d).laplacian.value, roundoff * unit);
      EXPECT_NEAR(other.at(d).laplacian.slope, reference.at(d).laplacian.slope, roundoff * unit);
    }
    EXPECT_NEAR(other.images().oseen.value, reference.images().oseen.value, roundoff * unit);
    EXPECT_NEAR(other.images().laplacian.value, reference.images().laplacian.value, roundoff * unit);
  }
}

// The size term against fourth-order differences of the Oseen term at a point off the line.
TEST(PeriodicStokes, SizeTermIsLaplacianOfOseenTerm) {
  const Vec3 periods(60, 50, 40), place(9, 7, 11);
  const double h = 0.05;
  const auto oseen = [&](int axis, double step) {
    Vec3 at = place;
    at[axis] += step;
    return off_the_line(at[0], at[1], at[2], periods).oseen.value;
  };
  double laplacian = 0;
  for (int axis = 0; axis < 3; ++axis) {
    laplacian += (-oseen(axis, 2 * h) + 16 * oseen(axis, h) - 30 * oseen(axis, 0) + 16 * oseen(axis, -h) -
                  oseen(axis, -2 * h)) /
                 (12 * h * h);
  }
  constexpr double truncation = 1e-7;  // of order (h/r)^4, and roundoff over h^2, relative
  const double size_term = off_the_line(place[0], place[1], place[2], periods).laplacian.value;
  EXPECT_NEAR(6 * size_term / laplacian, 1, truncation);
}

TEST(PeriodicStokes, SlopesAreDerivatives) {
  const PeriodicStokes flow(
      eta, periodic_line({.lengths = {128, 80, 96},
                          .boundary = {Boundary::periodic, Boundary::free_slip, Boundary::periodic}},
                         11, 40));
  const double h = 1e-3;
  constexpr double truncation = 1e-7;  // of order (h/d)^2, relative
  for (const double d : {-50.0, 8.0, 30.0}) {
    const SteadyLine after = flow.at(d + h), before = flow.at(d - h), here = flow.at(d);
    EXPECT_NEAR((after.oseen.value - before.oseen.value) / (2 * h) / here.oseen.slope, 1, truncation);
    EXPECT_NEAR((after.laplacian.value - before.laplacian.value) / (2 * h) / here.laplacian.slope, 1,
                truncation);
  }
}

}  // namespace
}  // namespace beadswim
