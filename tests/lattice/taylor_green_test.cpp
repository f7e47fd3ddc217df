#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "fluid_box.hpp"
#include "taylor_green.hpp"

namespace beadswim::test {
namespace {

constexpr double tau = 0.8;

/// Returns the Taylor-Green vortex in the plane (x, y) at the centre of a cell.
CellMoments taylor_green(double speed, int n, const Index3& cell) {
  return test::taylor_green(speed, n, (cell.cast<double>() + 0.5).matrix(), 0, 1);
}

/// Returns the relative L2 error of the velocity after the vortex has decayed to about a third. In the
/// diffusive scaling used here, speed ~ 1/n at fixed tau, the errors of time step and compressibility also
/// decrease as 1/n^2.
double decay_error(int n) {
  const double speed = 0.5 / n;
  FluidBox box(Index3(n, n, 1), {Boundary::periodic, Boundary::periodic, Boundary::periodic}, tau);
  box.set([&](const Index3& p) { return taylor_green(speed, n, p); });
  const double rate = 2 * lattice_viscosity(tau) * std::pow(2 * std::numbers::pi / n, 2);
  const int steps = n * n / 8;
  box.steps(steps);
  const double decay = std::exp(-rate * steps);
  double error = 0, scale = 0;
  for_each_cell(box.populations, [&](const Index3& p, std::ptrdiff_t) {
    const Vec3 exact = decay * taylor_green(speed, n, p).momentum;
    error += (box.velocity(p[0], p[1], p[2]) - exact).squaredNorm();
    scale += exact.squaredNorm();
  });
  return std::sqrt(error / scale);
}

// Catches a wrong viscosity, a wrong equilibrium (the vortex then deforms) and first-order streaming.
TEST(TaylorGreen, DecaysWithViscosityToSecondOrder) {
  const std::array errors{decay_error(16), decay_error(32), decay_error(64)};
  for (int fine = 1; fine < 3; ++fine) {
    const double order = std::log2(errors[fine - 1] / errors[fine]);
    EXPECT_GT(order, 1.8) << errors[fine - 1] << " -> " << errors[fine];
    EXPECT_LT(order, 2.3) << errors[fine - 1] << " -> " << errors[fine];
  }
  EXPECT_LT(errors[2], 2e-3);
}

// A free-slip wall is a mirror: the vortex array between its symmetry planes n/4 and 3n/4, where cos kx and
// cos ky vanish. Catches a wrong mirror direction or a wall off the half-way plane.
TEST(FreeSlipWall, IsAMirrorPlaneOfTheTaylorGreenVortex) {
  constexpr int n = 16;
  const auto shifted = [](const Index3& p) { return taylor_green(0.02, n, p + Index3(n / 4, n / 4, 0)); };
  FluidBox periodic(Index3(n, n, 1), {Boundary::periodic, Boundary::periodic, Boundary::periodic}, tau);
  FluidBox walled(Index3(n / 2, n / 2, 1), {Boundary::free_slip, Boundary::free_slip, Boundary::periodic},
                  tau);
  periodic.set(shifted);
  walled.set(shifted);
  periodic.steps(100);
  walled.steps(100);
  for_each_cell(walled.populations, [&](const Index3& p, std::ptrdiff_t) {
    constexpr double roundoff = 1e-15;
    EXPECT_LT((walled.velocity(p[0], p[1], p[2]) - periodic.velocity(p[0], p[1], p[2])).norm(), roundoff);
  });
}

}  // namespace
}  // namespace beadswim::test
