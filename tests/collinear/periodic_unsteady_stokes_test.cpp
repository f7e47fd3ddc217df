#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "beadswim/collinear/line_flow.hpp"
#include "beadswim/collinear/unsteady_sphere.hpp"
#include "beadswim/collinear/unsteady_stokes.hpp"
#include "beadswim/core/error.hpp"
#include "oscillation.hpp"

namespace beadswim {
namespace {

constexpr double eta = 1.0 / 3;  // [mass/(length time)]
constexpr double pi = std::numbers::pi;

void expect_near(const LineKernel<Complex>& a, const LineKernel<Complex>& b, double tolerance) {
  EXPECT_NEAR(std::abs(a.value - b.value), 0, tolerance);
  EXPECT_NEAR(std::abs(a.by_receiver - b.by_receiver), 0, tolerance);
}

LineFlow flow_of_period(double period, double height) {
  return LineFlow(eta,
                  {.lengths = {period, 80, height},
                   .boundary = {Boundary::periodic, Boundary::free_slip, Boundary::free_slip}},
                  31, 40);
}

// A longer box with several forces has another splitting, which also chooses between Ewald's sum and plain
// images: all must agree. Catches a wrong own term.
TEST(PeriodicUnsteadyStokes, IsThatOfSeveralForcesInALongerBox) {
  const LineFlow reference = flow_of_period(60, 96);
  for (const double modulus : {1e-5, 1e-3, 0.06, 0.12, 0.14, 0.17, 0.2}) {
    const Complex alpha = alpha_of_modulus(modulus);
    const UnsteadyFlow largest = reference.unsteady(alpha, 9, 0);
    const double of_whole = 2e-14 * std::abs(largest.total.value);
    const double of_parts = 1e-13 * std::abs(largest.harmonic.value);  // the parts may cancel
    for (const int copies : {3, 8}) {
      const LineFlow longer = flow_of_period(60 * copies, 96);
      for (const double d : {0.0, 9.0, 31.0, 50.0}) {
        UnsteadyFlow sum = d == 0 ? longer.unsteady_images(alpha, 0) : longer.unsteady(alpha, d, 0);
        for (int n = 1; n < copies; ++n) {
          const auto [helmholtz, harmonic, total] = longer.unsteady(alpha, d + 60 * n, 0);
          sum.helmholtz += helmholtz;
          sum.harmonic += harmonic;
          sum.total += total;
        }
        const auto flow = d == 0 ? reference.unsteady_images(alpha, 0) : reference.unsteady(alpha, d, 0);
        expect_near(sum.total, flow.total, of_whole);
        expect_near(sum.helmholtz, flow.helmholtz, of_parts);
        expect_near(sum.harmonic, flow.harmonic, of_parts);
      }
    }
  }
}

// Three sums of different origin: the total, and its parts, of which the harmonic is of the steady lattice.
TEST(PeriodicUnsteadyStokes, WholeIsSumOfParts) {
  const LineFlow flow(
      eta,
      {.lengths = {128, 80, 96}, .boundary = {Boundary::periodic, Boundary::free_slip, Boundary::periodic}},
      31, 40);
  for (const double modulus : {1e-3, 1e-2, 0.1, 0.2}) {
    const Complex alpha = alpha_of_modulus(modulus);
    const auto near = flow.unsteady(alpha, 9, 0);
    const double roundoff = 1e-13 * std::abs(near.harmonic.value);  // the largest part
    for (const auto& [helmholtz, harmonic, total] :
         {near, flow.unsteady(alpha, 50, 0), flow.unsteady_images(alpha, 0)}) {
      LineKernel<Complex> sum = helmholtz;
      sum += harmonic;
      expect_near(sum, total, roundoff);
    }
  }
}

/// Returns the Fourier transform of the force that a sphere induces, divided by the total force: j0 for the
/// part on the surface, 3 j1(x)/x for the part in the volume.
Complex form_factor(Complex kappa, double x) {
  if (x == 0) return 1;
  const double surface = std::sin(x) / x, volume = 3 * (surface - std::cos(x)) / (x * x);
  return ((1.0 + kappa) * surface + kappa * kappa / 3.0 * volume) / induced_force_factor(kappa);
}

// Two spheres by summing over k as it stands. A Gaussian exp(-k^2 smear) makes it converge: spread by it,
// helmholtz flow grows by exp(alpha^2 smear) and harmonic flow not at all, as long as it stays in the gap.
TEST(PeriodicUnsteadyStokes, AgreesWithSumOverWavesOfTwoSpheres) {
  const double a = 4, b = 3, d = 19, smear = 1.5;  // gap^2/(4 smear) = 24
  const Vec3 box(44, 36, 40);
  const int last = 36;  // k^2 smear = 40
  for (const double modulus : {0.02, 0.15}) {
    const Complex alpha = alpha_of_modulus(modulus), alpha2 = alpha * alpha;
    Complex sum = 0;
    for (int i = 0; i <= last; ++i) {
      for (int j = 0; j <= last; ++j) {
        for (int l = 0; l <= last; ++l) {
          const double kx = 2 * pi * i / box[0], ky = 2 * pi * j / box[1], kz = 2 * pi * l / box[2];
          const double k2 = kx * kx + ky * ky + kz * kz, k = std::sqrt(k2);
          const double signs = (i ? 2 : 1) * (j ? 2 : 1) * (l ? 2 : 1);
          const double across = k2 > 0 ? 1 - kx * kx / k2 : 1;
          sum += signs * across * std::exp(-k2 * smear) * std::cos(kx * d) / (k2 + alpha2) *
                 form_factor(alpha * a, k * a) * form_factor(alpha * b, k * b);
        }
      }
    }
    sum /= eta * box[0] * box[1] * box[2];
    const LineFlow flow(eta, {.lengths = box, .boundary = {}}, 1, 2);
    const SizeFactor spread{std::exp(alpha2 * smear) - 1.0};
    const auto pair =
        total_flow(flow.unsteady(alpha, d, 0), sphere_factor(alpha * a) * sphere_factor(alpha * b) * spread);
    constexpr double truncation = 1e-9;  // tails of the Gaussian over the gap
    EXPECT_NEAR(std::abs(pair.value / sum - 1.0), 0, truncation) << "alpha = " << modulus;
  }
}

// Differences between places know nothing of the uniform flow; they differ from steady flow as omega. The own
// place has the regular part of its own flow, -alpha/(6 pi eta) (Basset's force), beside its images.
TEST(PeriodicUnsteadyStokes, TendsToSteadyFlowOfForcesThatSumToZero) {
  const Box box{.lengths = {128, 80, 80},
                .boundary = {Boundary::periodic, Boundary::free_slip, Boundary::periodic}};
  const LineFlow flow(eta, box, 31, 40);
  const auto difference = [&](double modulus) {
    const Complex alpha = alpha_of_modulus(modulus);
    const Complex own = flow.unsteady_images(alpha, 60).total.value - alpha / (6 * pi * eta);
    return flow.unsteady(alpha, 60, 40).total.value - own -
           (flow.steady(60, 40).oseen.value - flow.steady_images(60).oseen.value);
  };
  EXPECT_NEAR(std::log2(std::abs(difference(1e-3) / difference(5e-4))), 2, 1e-3);
  EXPECT_NEAR(std::abs(difference(1e-5)), 0, 1e-8);
}

// Walls on x leave no uniform flow at all.
TEST(PeriodicUnsteadyStokes, TendsToSteadyFlowBetweenEndWalls) {
  const LineFlow flow(
      eta,
      {.lengths = {128, 80, 80}, .boundary = {Boundary::free_slip, Boundary::free_slip, Boundary::periodic}},
      31, 40);
  const auto difference = [&](double modulus) {
    const Complex alpha = alpha_of_modulus(modulus);
    const auto unsteady = flow.unsteady(alpha, 60, 40).total;
    const auto steady = flow.steady(60, 40).oseen;
    return std::abs(unsteady.value - steady.value) + std::abs(unsteady.by_source - steady.by_source);
  };
  EXPECT_NEAR(std::log2(difference(1e-3) / difference(5e-4)), 2, 1e-2);
  EXPECT_NEAR(difference(1e-6), 0, 1e-9);
}

TEST(PeriodicUnsteadyStokes, DoesNotCrossAFreeSlipWall) {
  const LineFlow flow(
      eta,
      {.lengths = {90, 60, 50}, .boundary = {Boundary::free_slip, Boundary::free_slip, Boundary::periodic}},
      20, 10);
  constexpr double near = 1e-9, slope_over_near_wall = 1e-9;
  for (const double modulus : {1e-3, 0.1, 1.0}) {
    const auto by_wall = flow.unsteady(alpha_of_modulus(modulus), near, 30);
    EXPECT_NEAR(std::abs(by_wall.total.value), 0, slope_over_near_wall);
    EXPECT_NEAR(std::abs(by_wall.helmholtz.value) * modulus * modulus, 0, slope_over_near_wall);
  }
}

TEST(PeriodicUnsteadyStokes, DerivativesByPlacesAreDerivatives) {
  const LineFlow flow(
      eta,
      {.lengths = {90, 60, 50}, .boundary = {Boundary::free_slip, Boundary::free_slip, Boundary::periodic}},
      20, 10);
  const double h = 1e-3, receiver = 70, source = 55;
  constexpr double truncation = 1e-6;  // of order (h/distance)^2 and (alpha h)^2, relative
  for (const double modulus : {1e-3, 0.1, 1.0}) {
    const Complex alpha = alpha_of_modulus(modulus);
    const auto here = flow.unsteady(alpha, receiver, source).total;
    const Complex by_receiver = (flow.unsteady(alpha, receiver + h, source).total.value -
                                 flow.unsteady(alpha, receiver - h, source).total.value) /
                                (2 * h);
    const Complex by_source = (flow.unsteady(alpha, receiver, source + h).total.value -
                               flow.unsteady(alpha, receiver, source - h).total.value) /
                              (2 * h);
    EXPECT_NEAR(std::abs(by_receiver / here.by_receiver - 1.0), 0, truncation);
    EXPECT_NEAR(std::abs(by_source / here.by_source - 1.0), 0, truncation);
  }
}

// With the viscous layer far shorter than the box, images reach over it by potential flow alone.
TEST(PeriodicUnsteadyStokes, FeelsImagesAsPotentialFlowAtHighFrequency) {
  const LineFlow flow(eta, {.lengths = {60, 60, 60}, .boundary = {}}, 0, 0);
  constexpr double roundoff = 1e-12;
  for (const double modulus : {2.0, 1000.0 / 60}) {
    const Complex alpha = alpha_of_modulus(modulus);
    const auto free = unsteady_stokeslet(eta, alpha, 6, 0).helmholtz.value;
    EXPECT_NEAR(std::abs(flow.unsteady(alpha, 6, 0).helmholtz.value - free), 0, roundoff * std::abs(free));
    // Lorentz: images of a cubic lattice of dipoles and its neutral background give 1/(3 V) at a dipole.
    const Complex lorentz = 1.0 / (3 * eta * alpha * alpha * std::pow(60.0, 3));
    EXPECT_NEAR(std::abs(flow.unsteady_images(alpha, 0).total.value / lorentz - 1.0), 0, roundoff);
  }
}

TEST(PeriodicUnsteadyStokes, RefusesAlphaWithoutPositiveRealPart) {
  const LineFlow flow(eta);
  EXPECT_THROW(flow.unsteady(0, 1, 0), InputError);
  EXPECT_THROW(flow.unsteady({-1, 1}, 1, 0), InputError);
  EXPECT_THROW(flow.unsteady({1, 1.1}, 1, 0), InputError);
}

}  // namespace
}  // namespace beadswim
