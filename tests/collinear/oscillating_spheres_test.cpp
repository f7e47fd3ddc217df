#include "beadswim/collinear/oscillating_spheres.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <array>
#include <cmath>
#include <numbers>

#include "beadswim/collinear/multipole_mobility.hpp"
#include "beadswim/core/complex.hpp"

namespace beadswim {
namespace {

constexpr double pi = std::numbers::pi, viscosity = 1.3;
constexpr std::array radii{1.0, 1.0, 2.0}, positions{0.0, 2.5, 7.5};

/// Returns alpha with the phase of sqrt(i).
Complex alpha_of(double size) {
  return std::polar(size, pi / 4);
}

// Basset's force on a lone sphere, from slow to fast oscillation; both choices of the second series.
TEST(OscillatingSpheres, ALoneOneHasBassetsResistance) {
  constexpr double roundoff = 1e-13;
  constexpr double a = 1.7, place = 0.4;
  for (const double kappa : {1e-6, 1e-3, 0.1, 1.0, 3.9, 4.1, 10.0, 100.0}) {
    const Complex x = alpha_of(kappa);
    const OscillatingSpheres sphere({&a, 1}, {&place, 1}, viscosity, x / a, 6);
    const Complex basset = 6 * pi * viscosity * a * (1.0 + x + x * x / 9.0);
    EXPECT_LT(std::abs(sphere.resistance()(0, 0) / basset - 1.0), roundoff) << "kappa = " << kappa;
  }
}

// The flow of a lone sphere (Landau and Lifshitz, Fluid Mechanics, section 24), with the constants of its own
// formula: u = curl curl (f U), f = A e^{-alpha r}/r + B/r.
TEST(OscillatingSpheres, ALoneOneHasTheFlowOfTheTextbook) {
  constexpr double roundoff = 1e-12;
  constexpr double a = 1, place = 0, r = 1.8, theta = 0.7;
  for (const double size : {0.3, 2.0, 6.0}) {
    const Complex k = alpha_of(size);
    const OscillatingSpheres sphere({&a, 1}, {&place, 1}, viscosity, k, 4);
    // u_r = -2 cos(theta) f'/r, u_theta = sin(theta) (f'' + f'/r). No slip: f' = -a/2, f'' = -1/2 at r = a.
    const auto slope = [&](double x) { return -(1.0 + k * x) * std::exp(-k * x) / (x * x); };
    const auto curvature = [&](double x) {
      return (2.0 + 2.0 * k * x + k * k * x * x) * std::exp(-k * x) / (x * x * x);
    };
    Eigen::Matrix2cd no_slip;
    no_slip << slope(a), -1.0, curvature(a), 2.0;
    const Eigen::Vector2cd c = no_slip.inverse() * Eigen::Vector2cd(-0.5, -0.5);
    const Complex f1 = c[0] * slope(r) - c[1] / (r * r), f2 = c[0] * curvature(r) + 2.0 * c[1] / (r * r * r);
    const Complex u_r = -2 * std::cos(theta) * f1 / r, u_theta = std::sin(theta) * (f2 + f1 / r);
    const Eigen::Matrix2Xcd u = sphere.at(r * std::cos(theta), r * std::sin(theta)).velocity;
    EXPECT_LT(std::abs(u(0, 0) - (u_r * std::cos(theta) - u_theta * std::sin(theta))), roundoff);
    EXPECT_LT(std::abs(u(1, 0) - (u_r * std::sin(theta) + u_theta * std::cos(theta))), roundoff);
  }
}

// Another solution of the steady flow: Papkovich-Neuber potentials, reflected from sphere to sphere.
TEST(OscillatingSpheres, WithoutInertiaHaveTheResistanceOfSteadyFlow) {
  constexpr double truncation = 1e-10;
  const Eigen::MatrixXd mobility = multipole_mobility(radii, positions, viscosity).value;
  const auto deviation = [&](Complex alpha) {
    const OscillatingSpheres spheres(radii, positions, viscosity, alpha, 20);
    return (spheres.resistance() * mobility - Eigen::Matrix3cd::Identity()).cwiseAbs().maxCoeff();
  };
  EXPECT_LT(deviation(0), truncation);
  EXPECT_NEAR(deviation(alpha_of(1e-5)) / 1e-5, deviation(alpha_of(1e-6)) / 1e-6,
              1e-3);  // of first order in alpha
}

TEST(OscillatingSpheres, CarryTheFluidOnTheirSurfaces) {
  constexpr double truncation = 1e-7;
  for (const double size : {0.1, 1.0, 3.0, 10.0}) {
    const OscillatingSpheres spheres(radii, positions, viscosity, alpha_of(size), 28);
    for (int j = 0; j < 3; ++j) {
      Eigen::RowVector3cd own = Eigen::RowVector3cd::Zero();
      own[j] = 1;
      for (double cosine = -0.95; cosine < 1; cosine += 0.1) {
        const double sine = std::sqrt(1 - cosine * cosine);
        const Eigen::Matrix2Xcd u = spheres.at(positions[j] + radii[j] * cosine, radii[j] * sine).velocity;
        EXPECT_LT((u.row(0) - own).cwiseAbs().maxCoeff(), truncation);
        EXPECT_LT(u.row(1).cwiseAbs().maxCoeff(), truncation);
      }
    }
  }
}

// Reciprocity and convergence with the order.
TEST(OscillatingSpheres, HaveASymmetricResistance) {
  for (const double size : {0.1, 1.0, 3.0, 10.0}) {
    const auto asymmetry = [&](int order) {
      const Eigen::MatrixXcd r =
          OscillatingSpheres(radii, positions, viscosity, alpha_of(size), order).resistance();
      return (r - r.transpose()).cwiseAbs().maxCoeff() / r.cwiseAbs().maxCoeff();
    };
    EXPECT_LT(asymmetry(8), 1e-5);
    EXPECT_LT(asymmetry(16), 1e-9);
    EXPECT_LT(asymmetry(28), 1e-14);
  }
}

// The equations of motion: div u = 0, and the vorticity w obeys laplacian w - w/s^2 = alpha^2 w. Differences
// of the gradients, which are compared with differences of the velocity.
TEST(OscillatingSpheres, ObeyTheEquationsOfMotion) {
  constexpr double x = 1.3, s = 1.6, h = 1e-3;
  for (const double size : {0.2, 0.7, 5.0}) {
    const Complex alpha = alpha_of(size);
    const OscillatingSpheres spheres(radii, positions, viscosity, alpha, 12);
    const FlowAtPoint flow = spheres.at(x, s);
    const auto& g = flow.gradient;
    const Eigen::Matrix2Xcd along = (spheres.at(x + h, s).velocity - spheres.at(x - h, s).velocity) / (2 * h);
    const Eigen::Matrix2Xcd across =
        (spheres.at(x, s + h).velocity - spheres.at(x, s - h).velocity) / (2 * h);
    EXPECT_LT((along - g.topRows(2)).cwiseAbs().maxCoeff(), 1e-4);
    EXPECT_LT((across - g.bottomRows(2)).cwiseAbs().maxCoeff(), 1e-4);
    EXPECT_LT((g.row(0) + g.row(3) + flow.velocity.row(1) / s).cwiseAbs().maxCoeff(), 1e-13);
    const auto vorticity = [&](double px, double ps) {
      const auto gradient = spheres.at(px, ps).gradient;
      return Eigen::RowVector3cd(gradient.row(1) - gradient.row(2));
    };
    const Eigen::RowVector3cd w = vorticity(x, s), east = vorticity(x + h, s), west = vorticity(x - h, s),
                              north = vorticity(x, s + h), south = vorticity(x, s - h);
    const Eigen::RowVector3cd diffusion =
        (east + west + north + south - 4 * w) / (h * h) + (north - south) / (2 * h * s) - w / (s * s);
    EXPECT_LT((diffusion - alpha * alpha * w).cwiseAbs().maxCoeff(), 1e-4);
  }
}

}  // namespace
}  // namespace beadswim
