#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "fluid_box.hpp"

namespace beadswim::test {
namespace {

/// Returns the velocity of steady flow between plates at y = 0 and y = h, driven by a body force F: u = F y
/// (h - y) / (2 nu).
double plate_flow(double force, double viscosity, double h, double y) {
  return force * y * (h - y) / (2 * viscosity);
}

/// Returns the velocity of steady flow in a square duct with walls at 0 and h (series of White, Viscous Fluid
/// Flow, 3-48).
double duct_flow(double force, double viscosity, double h, double y, double z) {
  constexpr double pi = std::numbers::pi;
  double sum = 0;
  for (int n = 1; n < 200; n += 2) {
    const double k = n * pi / h;
    // cosh(k (z - h/2)) / cosh(k h/2), without overflow
    const double ratio = (std::exp(-k * z) + std::exp(-k * (h - z))) / (1 + std::exp(-k * h));
    sum += 4 * h * h / (pi * pi * pi * n * n * n) * (1 - ratio) * std::sin(k * y);
  }
  return force / viscosity * sum;
}

class TrtPoiseuille : public testing::TestWithParam<std::tuple<double, int>> {};

// Catches a wrong w- (the wall then moves with viscosity), a wrong wall axis, a missing bounce-back
// direction.
TEST_P(TrtPoiseuille, WallSitsHalfwayAtMagic3Over16) {
  const auto [relaxation_time, across] = GetParam();
  const int along = (across + 1) % 3;
  constexpr int n = 6;
  Index3 cells = Index3::Constant(2);
  cells[across] = n;
  std::array<Boundary, 3> walls{Boundary::periodic, Boundary::periodic, Boundary::periodic};
  walls[across] = Boundary::no_slip;
  FluidBox box(cells, walls, relaxation_time);
  const double viscosity = lattice_viscosity(relaxation_time);
  box.body_force[along] = 1e-6;
  box.steps(static_cast<int>(20 * n * n / viscosity / 9.87) + 200);  // 20 times the slowest decay

  for (int y = 0; y < n; ++y) {
    Index3 p = Index3::Zero();
    p[across] = y;
    const double exact = plate_flow(1e-6, viscosity, n, y + 0.5);
    constexpr double roundoff = 1e-8;  // 20 e-foldings of the start-up, and the digits of a steady state
    EXPECT_NEAR(box.velocity(p[0], p[1], p[2])[along] / exact, 1, roundoff);
  }
}

INSTANTIATE_TEST_SUITE_P(TausAndAxes, TrtPoiseuille,
                         testing::Combine(testing::Values(0.6, 1.5, 3.0), testing::Values(0, 1, 2)));

double duct_error(int n) {
  constexpr double tau = 1.5;
  FluidBox box(Index3(1, n, n), {Boundary::periodic, Boundary::no_slip, Boundary::no_slip}, tau);
  const double viscosity = lattice_viscosity(tau);
  box.body_force = Vec3(1e-6, 0, 0);
  box.steps(static_cast<int>(25 * n * n / viscosity / 19.7));
  double error = 0, scale = 0;
  for (int y = 0; y < n; ++y) {
    for (int z = 0; z < n; ++z) {
      const double exact = duct_flow(1e-6, viscosity, n, y + 0.5, z + 0.5);
      error += std::pow(box.velocity(0, y, z)[0] - exact, 2);
      scale += exact * exact;
    }
  }
  return std::sqrt(error / scale);
}

// Catches an error of first order at walls or in their corners.
TEST(TrtDuct, ConvergesWithSecondOrder) {
  const std::array errors{duct_error(6), duct_error(12), duct_error(24)};
  for (int fine = 1; fine < 3; ++fine) {
    const double order = std::log2(errors[fine - 1] / errors[fine]);
    EXPECT_GT(order, 1.8) << errors[fine - 1] << " -> " << errors[fine];
    EXPECT_LT(order, 2.3) << errors[fine - 1] << " -> " << errors[fine];
  }
  EXPECT_LT(errors[2], 2e-3);
}

}  // namespace
}  // namespace beadswim::test
