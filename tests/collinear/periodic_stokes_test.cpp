#include <gtest/gtest.h>

#include <cmath>

#include "beadswim/collinear/line_flow.hpp"
#include "beadswim/collinear/pair_mobility.hpp"

namespace beadswim {
namespace {

constexpr double eta = 1.0 / 3;  // [mass/(length time)]
constexpr Boundary periodic = Boundary::periodic, walls = Boundary::free_slip;

/// Returns the flow at (d, y, z) of a periodic lattice of forces at the origin, as the contribution of mirror
/// images at y and z: a box of half the period between walls, with the line at half of y, has a mirror image
/// at y.
SteadyFlow off_the_line(double d, double y, double z, const Vec3& periods) {
  const auto with_copies = [&](double at_y, double at_z) {
    const Box box{.lengths = {periods[0], at_y > 0 ? periods[1] / 2 : periods[1],
                              at_z > 0 ? periods[2] / 2 : periods[2]},
                  .boundary = {periodic, at_y > 0 ? walls : periodic, at_z > 0 ? walls : periodic}};
    return LineFlow(eta, box, at_y / 2, at_z / 2).steady(d, 0);
  };
  SteadyFlow flow = with_copies(y, z);
  const SteadyFlow axis = with_copies(0, 0), only_y = with_copies(y, 0), only_z = with_copies(0, z);
  for (const auto part : {&SteadyFlow::oseen, &SteadyFlow::laplacian}) {
    flow.*part += -1 * (only_y.*part);
    flow.*part += -1 * (only_z.*part);
    flow.*part += axis.*part;
  }
  return flow;
}

// A box of several periods with a force in each has another splitting of the sums: a missing or doubled piece
// of either sum, or a wrong flow of the force itself, depends on it.
TEST(PeriodicStokes, IsThatOfSeveralForcesInALongerBox) {
  const LineFlow reference(eta, {.lengths = {60, 80, 96}, .boundary = {periodic, walls, walls}}, 31, 40);
  const double unit = self_mobility(4, eta);
  constexpr double roundoff = 1e-13;  // of a bead's own mobility, a = 4
  for (const int copies : {3, 8}) {   // the splittings have the ratios 0.7 and 0.5
    const LineFlow longer(eta, {.lengths = {60.0 * copies, 80, 96}, .boundary = {periodic, walls, walls}}, 31,
                          40);
    const auto sum_at = [&](double d) {
      SteadyFlow sum = d == 0 ? longer.steady_images(0) : longer.steady(d, 0);
      for (int n = 1; n < copies; ++n) {
        const SteadyFlow flow = longer.steady(d + 60 * n, 0);
        sum.oseen += flow.oseen;
        sum.laplacian += flow.laplacian;
      }
      return sum;
    };
    for (const double d : {0.0, 9.0, 31.0, 50.0}) {
      const SteadyFlow sum = sum_at(d), flow = d == 0 ? reference.steady_images(0) : reference.steady(d, 0);
      EXPECT_NEAR(sum.oseen.value, flow.oseen.value, roundoff * unit);
      EXPECT_NEAR(sum.oseen.by_receiver, flow.oseen.by_receiver, roundoff * unit);
      EXPECT_NEAR(sum.laplacian.value, flow.laplacian.value, roundoff * unit);
      EXPECT_NEAR(sum.laplacian.by_receiver, flow.laplacian.by_receiver, roundoff * unit);
    }
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
  const LineFlow flow(eta, {.lengths = {128, 80, 96}, .boundary = {periodic, walls, periodic}}, 11, 40);
  const double h = 1e-3;
  constexpr double truncation = 1e-7;  // of order (h/d)^2, relative
  for (const double d : {-50.0, 8.0, 30.0}) {
    const SteadyFlow after = flow.steady(d + h, 0), before = flow.steady(d - h, 0), here = flow.steady(d, 0);
    EXPECT_NEAR((after.oseen.value - before.oseen.value) / (2 * h) / here.oseen.by_receiver, 1, truncation);
    EXPECT_NEAR((after.laplacian.value - before.laplacian.value) / (2 * h) / here.laplacian.by_receiver, 1,
                truncation);
  }
}

}  // namespace
}  // namespace beadswim
