#include "lone_sphere_flow.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "beadswim/core/complex.hpp"

// Tests the flow of a single sphere with the equations that this flow must satisfy.

namespace beadswim {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double a = 4, eta = 1.0 / 3;
const Complex diagonal(std::sqrt(0.5), std::sqrt(0.5));  // the direction of alpha

/// A position outside the sphere, given by the distance and the angle to the axis.
struct Place {
  double x, s;
};
Place at(double r, double angle) {
  return {r * std::cos(angle), r * std::sin(angle)};
}

/// Flow u and its derivatives by fourth-order differences with step h.
struct Differences {
  Eigen::RowVector2cd flow, by_x, by_s, by_xx, by_ss;
};

Differences differences(Complex alpha, Place place, double h) {
  const auto u = [&](double dx, double ds) {
    return oscillating_sphere_flow(a, eta, alpha, place.x + dx, place.s + ds);
  };
  const auto first = [h](const auto& f) {
    return Eigen::RowVector2cd((8.0 * (f(h) - f(-h)) - f(2 * h) + f(-2 * h)) / (12 * h));
  };
  const auto second = [h](const auto& f) {
    return Eigen::RowVector2cd((16.0 * (f(h) + f(-h)) - f(2 * h) - f(-2 * h) - 30.0 * f(0)) / (12 * h * h));
  };
  const auto along = [&](double d) { return u(d, 0); };
  const auto away = [&](double d) { return u(0, d); };
  return {u(0, 0), first(along), first(away), second(along), second(away)};
}

constexpr double step = 0.01;
constexpr double truncation = 2e-8;  // of fourth order: (step/a)^4 = 4e-11 times derivatives by r/a

class OscillatingSphere : public testing::TestWithParam<double> {
 protected:
  Complex alpha() const { return GetParam() * diagonal; }
};

// The law of the sphere's own motion: it moves by f/(6 pi eta a D), and so does the fluid on its surface.
TEST_P(OscillatingSphere, DoesNotSlipOnItsSurface) {
  const double roundoff = 1e-14 * std::max(1.0, std::pow(GetParam() * a, -2));  // parts cancel as 1/kappa^2
  const Complex kappa = alpha() * a;
  const Complex motion = 1.0 / (6 * pi * eta * a * (1.0 + kappa + kappa * kappa / 3.0));
  for (const double angle : {0.0, 0.3, 1.2, pi / 2, 2.9}) {
    const auto [x, s] = at(std::nextafter(std::nextafter(a, 9), 9), angle);
    const Eigen::RowVector2cd u = oscillating_sphere_flow(a, eta, alpha(), x, s) / motion;
    EXPECT_NEAR(std::abs(u[0] - 1.0), 0, roundoff) << "angle " << angle;
    EXPECT_NEAR(std::abs(u[1]), 0, roundoff) << "angle " << angle;
  }
}

TEST_P(OscillatingSphere, MakesFlowWithoutDivergence) {
  for (const double r : {4.3, 7.0, 30.0}) {
    const Place place = at(r, 0.8);
    const Differences d = differences(alpha(), place, step);
    const Complex divergence = d.by_x[0] + d.by_s[1] + d.flow[1] / place.s;
    EXPECT_LT(std::abs(divergence) * r / d.flow.norm(), truncation) << "r = " << r;
  }
}

// eta (laplacian - alpha^2) u = grad p with the pressure of a point force, x / (4 pi r^3): whatever its size,
// a sphere hands its induced force to the fluid.
TEST_P(OscillatingSphere, ObeysUnsteadyStokesEquation) {
  for (const double r : {4.3, 7.0, 30.0}) {
    const Place place = at(r, 0.8);
    const auto& [x, s] = place;
    const Differences d = differences(alpha(), place, step);
    Eigen::RowVector2cd laplacian = d.by_xx + d.by_ss + d.by_s / s;
    laplacian[1] -= d.flow[1] / (s * s);
    const Eigen::RowVector2cd pull = eta * (laplacian - alpha() * alpha() * d.flow);
    const Eigen::RowVector2d pressure_gradient =
        Eigen::RowVector2d(1 - 3 * x * x / (r * r), -3 * x * s / (r * r)) / (4 * pi * r * r * r);
    constexpr double roundoff = 2e-6;  // eps/kappa^2 over step^2, times r^2
    EXPECT_LT((pull - pressure_gradient).norm() * r * r * r, truncation + roundoff) << "r = " << r;
  }
}

INSTANTIATE_TEST_SUITE_P(Depths, OscillatingSphere, testing::Values(0.004, 0.06, 0.4, 2.0));

/// Returns Stokes's flow of a towed sphere per unit force: the textbook formula u = U (..., ...) with U =
/// 1/(6 pi eta a).
Eigen::RowVector2d stokes_flow(double x, double s) {
  const double r = std::hypot(x, s), q = a / r;
  const double cosine = x / r, sine = s / r;
  const double u_r = cosine * (1.5 * q - 0.5 * q * q * q), u_theta = -sine * (0.75 * q + 0.25 * q * q * q);
  return Eigen::RowVector2d(u_r * cosine - u_theta * sine, u_r * sine + u_theta * cosine) /
         (6 * pi * eta * a);
}

// At low frequency the flow is Stokes's less the uniform alpha/(6 pi eta), and the rest is of order alpha^2.
TEST(OscillatingSphereFlow, TendsToSteadyFlow) {
  const auto [x, s] = at(11, 0.6);
  const auto difference = [&, x = x, s = s](double size) {
    Eigen::RowVector2cd u = oscillating_sphere_flow(a, eta, size * diagonal, x, s) - stokes_flow(x, s);
    u[0] += size * diagonal / (6 * pi * eta);
    return u.norm() / stokes_flow(x, s).norm();
  };
  constexpr double slope_tolerance = 0.1;
  EXPECT_NEAR(std::log2(difference(4e-3) / difference(2e-3)), 2, slope_tolerance);
  EXPECT_NEAR(std::log2(difference(2e-3) / difference(1e-3)), 2, slope_tolerance);
  EXPECT_LT(difference(1e-3), 2e-4);
}

TEST(TowedSphere, GradientIsThatOfStokesFlow) {
  constexpr double h = 3e-4, step_truncation = 2e-10;  // central differences: h^2
  for (const double r : {4.01, 5.0, 12.0, 90.0}) {
    const auto [x, s] = at(r, 1.1);
    Eigen::Matrix2d expected;
    expected << (stokes_flow(x + h, s) - stokes_flow(x - h, s)) / (2 * h),
        (stokes_flow(x, s + h) - stokes_flow(x, s - h)) / (2 * h);
    EXPECT_LT((towed_sphere_gradient(a, eta, x, s) - expected).norm(), step_truncation) << "r = " << r;
  }
  EXPECT_EQ(towed_sphere_gradient(a, eta, 2, 3).norm(), 0);
}

// Trace and s-part: d_x u_x + d_s u_s + u_s/s = 0.
TEST(TowedSphere, MakesFlowWithoutDivergence) {
  constexpr double roundoff = 1e-15;
  for (const double r : {4.0001, 9.0, 70.0}) {
    const auto [x, s] = at(r, 2.2);
    EXPECT_NEAR(towed_sphere_gradient(a, eta, x, s).trace() + stokes_flow(x, s)[1] / s, 0, roundoff);
  }
}

}  // namespace
}  // namespace beadswim
