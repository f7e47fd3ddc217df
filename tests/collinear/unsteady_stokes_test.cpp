#include "beadswim/collinear/unsteady_stokes.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "beadswim/collinear/line_flow.hpp"
#include "beadswim/collinear/rotne_prager.hpp"
#include "beadswim/collinear/unsteady_sphere.hpp"
#include "oscillation.hpp"

namespace beadswim {
namespace {

constexpr double eta = 1.0 / 3;  // [mass/(length time)]
constexpr double pi = std::numbers::pi;

/// Returns the flow along x at (x, rho) of a single sphere at the origin, per unit of induced force.
Complex flow_of_sphere(Complex alpha, double radius, double x, double rho) {
  const UnsteadyFlow point = unsteady_stokeslet(eta, alpha, x, rho * rho);
  return point.total.value + sphere_factor(alpha * radius).excess * point.helmholtz.value;
}

/// Returns the closed form of G_xx on the line, evaluated with 64-bit mantissas. Cancellation loses digits in
/// proportion to 1/z^2, z: argument of the closed form.
Complex closed_form_on_line(std::complex<double> alpha_double, double distance) {
  using Long = std::complex<long double>;
  const long double one = 1, r = distance;
  const Long alpha(alpha_double), z = alpha * r;
  const Long curvature = (2 * one + 2 * one * z + z * z) * std::exp(-z) - 2 * one;
  const Long value = (std::exp(-z) / r - curvature / (alpha * alpha * r * r * r)) /
                     (4 * std::numbers::pi_v<long double> * static_cast<long double>(eta));
  return Complex(value);
}

// Both branches, and down to where the parts cancel by ten digits.
TEST(UnsteadyStokes, KeepsItsDigitsAtLowFrequency) {
  const double r = 20;
  for (const double z : {1e-4, 1e-3, 1e-2, 0.5, 0.999, 1.001, 3.0}) {
    const double roundoff = 1e-14 + 2e-18 / (z * z);  // of the code; of the 64-bit reference
    const Complex alpha = alpha_of_modulus(z / r);
    const Complex reference = closed_form_on_line(alpha, r);
    const UnsteadyFlow flow = unsteady_stokeslet(eta, alpha, r, 0);
    EXPECT_NEAR(std::abs(flow.total.value / reference - 1.0), 0, roundoff) << "alpha r = " << z;
    const double parts_cancel = 2e-15 / (z * z);  // they are 2/z^2 of the total, with some roundoffs each
    EXPECT_NEAR(std::abs(flow.helmholtz.value + flow.harmonic.value - flow.total.value), 0,
                (parts_cancel + 1e-15) * std::abs(reference))
        << "alpha r = " << z;
  }
}

TEST(UnsteadyStokes, SlopesAreDerivatives) {
  const double h = 2e-4, x = 9, rho2 = 5;
  constexpr double truncation = 1e-7;  // of order (h/r)^2 and (alpha h)^2, relative
  for (const double modulus : {0.01, 0.2, 1.0}) {
    const Complex alpha = alpha_of_modulus(modulus);
    const auto here = unsteady_stokeslet(eta, alpha, x, rho2);
    const auto after = unsteady_stokeslet(eta, alpha, x + h, rho2);
    const auto before = unsteady_stokeslet(eta, alpha, x - h, rho2);
    for (const auto part : {&UnsteadyFlow::helmholtz, &UnsteadyFlow::harmonic, &UnsteadyFlow::total}) {
      const Complex slope = ((after.*part).value - (before.*part).value) / (2 * h);
      EXPECT_NEAR(std::abs((here.*part).by_receiver / slope - 1.0), 0, truncation);
    }
  }
}

// alpha -> 0: G_xx -> Oseen - alpha/(6 pi eta), so halving alpha (omega to a quarter) halves the difference.
TEST(UnsteadyStokes, TendsToRotnePragerAsRootOfFrequency) {
  const double a = 4, b = 3, r = 20;
  const auto difference = [&](double modulus) {
    const Complex alpha = alpha_of_modulus(modulus);
    const auto factor = sphere_factor(alpha * a) * sphere_factor(alpha * b);
    return total_flow(LineFlow(eta).unsteady(alpha, r, 0), factor).value - rotne_prager(a, b, r, eta).value;
  };
  constexpr double truncation = 0.01;  // next order in alpha r
  EXPECT_NEAR(std::log2(std::abs(difference(1e-4) / difference(0.5e-4))), 1, truncation);
  const Complex leading = -alpha_of_modulus(1e-6) / (6 * pi * eta);
  EXPECT_NEAR(std::abs(difference(1e-6) / leading - 1.0), 0, 1e-4);
}

// The flow of a lone oscillating sphere is its own velocity all over its surface, at any frequency.
TEST(UnsteadySphere, DoesNotSlip) {
  constexpr double roundoff = 1e-13;
  const double a = 4;
  for (const double modulus : {1e-4, 0.05, 0.4, 3.0}) {
    const Complex alpha = alpha_of_modulus(modulus), kappa = alpha * a;
    const Complex force = 6 * pi * eta * a * induced_force_factor(kappa);  // for unit velocity
    for (const double angle : {0.0, 0.4, 1.1, pi / 2}) {
      const Complex along = force * flow_of_sphere(alpha, a, a * std::cos(angle), a * std::sin(angle));
      EXPECT_NEAR(std::abs(along - 1.0), 0, roundoff) << "alpha a = " << modulus * a << ", angle " << angle;
    }
    // Across the line, G_x rho = x rho (D^2 e^{-alpha r}/r, D^2 1/r)/(4 pi eta alpha^2), D = (1/r) d/dr.
    const Complex decaying = (3.0 + 3.0 * kappa + kappa * kappa) * std::exp(-kappa);
    EXPECT_NEAR(std::abs((1.0 + sphere_factor(kappa).excess) * decaying / 3.0 - 1.0), 0, roundoff);
  }
}

// Stress over the surface: pressure f x/(4 pi r^3) and eta du_x/dr (no slip leaves no more of the shear). The
// drag is -6 pi eta a (1 + kappa + kappa^2/9) U: Stokes, Basset and added mass.
TEST(UnsteadySphere, FeelsItsImpedance) {
  const double a = 4, h = 1e-3;
  for (const double modulus : {0.01, 0.05, 0.4, 1.0}) {
    const Complex alpha = alpha_of_modulus(modulus), kappa = alpha * a;
    const Complex force = 6 * pi * eta * a * induced_force_factor(kappa);
    const auto traction = [&](double cosine) {
      const double sine = std::sqrt(1 - cosine * cosine);
      const auto flow_at = [&](double r) { return flow_of_sphere(alpha, a, r * cosine, r * sine); };
      const Complex shear = eta * force * (flow_at(a + h) - flow_at(a - h)) / (2 * h);
      return shear - force * cosine * cosine / (4 * pi * a * a);
    };
    // Quadratic in the cosine: its mean is that at 1/sqrt(3).
    const Complex drag = 4 * pi * a * a * traction(1 / std::sqrt(3.0));
    const Complex impedance = 6 * pi * eta * a * (1.0 + kappa + kappa * kappa / 9.0);
    constexpr double truncation = 1e-6;  // of order (h/a)^2 (1 + |kappa|)^2, relative
    EXPECT_NEAR(std::abs(-drag / impedance - 1.0), 0, truncation);
  }
}

// The mean of e^{-alpha r}/r over a sphere's surface, its centre at a distance d: with r^2 = d^2 + a^2 - 2 a
// d c for the cosine c, an integral of e^{-alpha r}/(2 a d) over r. Two-point Gauss quadrature.
TEST(UnsteadySphere, SurfaceMeanMultipliesHelmholtzFlow) {
  const double a = 4, d = 11, width = 2 * a / 200, offset = width / 2 / std::sqrt(3.0);
  for (const double modulus : {1e-3, 0.1, 1.0}) {
    const Complex alpha = alpha_of_modulus(modulus);
    Complex mean = 0;
    for (double middle = d - a + width / 2; middle < d + a; middle += width) {
      mean +=
          width / (4 * a * d) * (std::exp(-alpha * (middle - offset)) + std::exp(-alpha * (middle + offset)));
    }
    const Complex expected = (1.0 + surface_mean_factor(alpha * a).excess) * std::exp(-alpha * d) / d;
    const double roundoff = 1e-13, truncation = std::pow(modulus * width, 4);
    EXPECT_NEAR(std::abs(mean / expected - 1.0), 0, roundoff + truncation);
  }
}

// The induced force's surface and volume shares, each with its own mean, give e^kappa/D.
TEST(UnsteadySphere, FactorIsThatOfItsInducedForce) {
  constexpr double roundoff = 1e-12;
  for (const double modulus : {0.3, 0.999, 1.001, 5.0}) {
    const Complex kappa = alpha_of_modulus(modulus);
    const Complex surface = std::sinh(kappa) / kappa;
    const Complex volume = 3.0 * (kappa * std::cosh(kappa) - std::sinh(kappa)) / (kappa * kappa * kappa);
    const Complex sum = (1.0 + kappa) * surface + kappa * kappa / 3.0 * volume;
    const Complex factor = 1.0 + sphere_factor(kappa).excess;
    EXPECT_NEAR(std::abs(sum / induced_force_factor(kappa) / factor - 1.0), 0, roundoff);
    EXPECT_NEAR(std::abs(surface / (1.0 + surface_mean_factor(kappa).excess) - 1.0), 0, roundoff);
  }
}

// kappa -> 0: excess = kappa^2/6 (1 + O(kappa)); plain subtraction would leave nothing of it here.
TEST(UnsteadySphere, FactorKeepsItsDigitsForSmallSpheres) {
  const Complex kappa = alpha_of_modulus(1e-9);
  constexpr double next_order = 1e-8;
  EXPECT_NEAR(std::abs(sphere_factor(kappa).excess / (kappa * kappa / 6.0) - 1.0), 0, next_order);
  EXPECT_NEAR(std::abs(surface_mean_factor(kappa).excess / (kappa * kappa / 6.0) - 1.0), 0, next_order);
}

}  // namespace
}  // namespace beadswim
