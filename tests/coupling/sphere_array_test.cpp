#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>

#include "fixed_sphere.hpp"

namespace beadswim::test {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double tau = 1.5;

/// Returns the drag coefficient K of a simple-cubic array of spheres of radius R: F = 6 pi eta R K U. U is
/// the superficial velocity. F is the body force on a unit cell, which includes the force of the mean
/// pressure gradient on the volume of the sphere.
double array_drag(double volume_fraction, double cells_per_diameter, const Vec3& offset, BeadScheme scheme,
                  double tau = test::tau) {
  const double per_edge = std::cbrt(6 * volume_fraction / pi);  // diameter / spacing
  const int edge = static_cast<int>(std::lround(cells_per_diameter / per_edge));
  const double radius = 0.5 * per_edge * edge;
  FixedSphere sphere(edge, radius, Vec3::Constant(edge / 2.0) + offset, tau, scheme);
  constexpr double g = 1e-6;
  sphere.fluid.body_force = Vec3(g, 0, 0);

  double superficial = 0, before = 1;
  while (std::abs(superficial - before) > 1e-7 * std::abs(superficial)) {
    for (int n = 0; n < 199; ++n) sphere.step();
    before = superficial;
    superficial = sphere.superficial_velocity()[0];
  }
  return g * std::pow(edge, 3) / (6 * pi * lattice_viscosity(tau) * radius * superficial);
}

struct Drag {
  double mean, spread;  ///< mean and standard deviation over positions within a cell
};
Drag mean_array_drag(double volume_fraction, double cells_per_diameter, BeadScheme scheme) {
  constexpr std::array offsets{std::array{0.0, 0.0, 0.0}, std::array{0.5, 0.5, 0.5},
                               std::array{0.25, 0.1, 0.4}, std::array{0.4, 0.2, 0.0}};
  double sum = 0, squares = 0;
  for (const auto& o : offsets) {
    const double drag = array_drag(volume_fraction, cells_per_diameter, Vec3(o[0], o[1], o[2]), scheme);
    sum += drag;
    squares += drag * drag;
  }
  const double mean = sum / offsets.size();
  return {mean, std::sqrt(std::max(0.0, squares / offsets.size() - mean * mean))};
}

struct Measured {
  double volume_fraction;
  double drag;         ///< reference: Zick & Homsy, J. Fluid Mech. 115 (1982) 13, table 2
  double diameter;     ///< diameter of a sphere [cell]
  double model_error;  ///< accepted error: of the radius, amplified in dense arrays
  BeadScheme scheme = BeadScheme::staircase;
};

class SimpleCubicArray : public testing::TestWithParam<Measured> {};

// Catches a wrong momentum exchange, refill or wall velocity: any of them changes the drag by tens of
// percent.
TEST_P(SimpleCubicArray, HasTheDragOfZickAndHomsy) {
  const Measured& m = GetParam();
  const auto [drag, spread] = mean_array_drag(m.volume_fraction, m.diameter, m.scheme);
  RecordProperty("relative_error", std::to_string(drag / m.drag - 1));
  std::printf("%s, phi %.3f, %g cells a diameter: K = %.3f, error %+.2f %%, spread %.2f %%\n",
              to_text(m.scheme).c_str(), m.volume_fraction, m.diameter, drag, 100 * (drag / m.drag - 1),
              100 * spread / m.drag);
  EXPECT_NEAR(drag / m.drag, 1, m.model_error);
  EXPECT_LT(spread / m.drag, m.model_error);
}

INSTANTIATE_TEST_SUITE_P(
    FractionsAndResolutions, SimpleCubicArray,
    testing::Values(
        Measured{0.027, 2.008, 8, 0.06}, Measured{0.064, 2.810, 8, 0.06}, Measured{0.125, 4.292, 8, 0.08},
        Measured{0.125, 4.292, 16, 0.04}, Measured{0.216, 7.442, 12, 0.08},
        Measured{0.027, 2.008, 8, 0.02, BeadScheme::cli}, Measured{0.125, 4.292, 8, 0.02, BeadScheme::cli},
        Measured{0.125, 4.292, 16, 0.01, BeadScheme::cli},
        Measured{0.125, 4.292, 4, 0.045, BeadScheme::mr},  // two cells between spheres
        Measured{0.125, 4.292, 8, 0.015, BeadScheme::mr}, Measured{0.125, 4.292, 16, 0.01, BeadScheme::mr},
        Measured{0.027, 2.008, 8, 0.01, BeadScheme::psm}, Measured{0.125, 4.292, 8, 0.02, BeadScheme::psm},
        Measured{0.125, 4.292, 16, 0.01, BeadScheme::psm}));

// What the law of the force in a cell is made for. Catches one that weakens or stiffens with the viscosity
// (Noble & Torczynski's weights: 13 % between these relaxation times).
TEST(SaturatedCells, HaveTheSameDragAtEveryViscosity) {
  const Vec3 offset(0.25, 0.1, 0.4);
  const double slow = array_drag(0.064, 6, offset, BeadScheme::psm, 0.8);
  const double fast = array_drag(0.064, 6, offset, BeadScheme::psm, 3);
  EXPECT_NEAR(fast / slow, 1, 1e-4);  // how far the runs are from steady
}

class TurningSphere : public testing::TestWithParam<std::tuple<BeadScheme, double>> {};
INSTANTIATE_TEST_SUITE_P(Schemes, TurningSphere,
                         testing::Values(std::tuple{BeadScheme::staircase, 0.12},
                                         std::tuple{BeadScheme::cli, 0.02}, std::tuple{BeadScheme::mr, 0.02},
                                         std::tuple{BeadScheme::psm, 0.02}));

// Torque on a slowly turning sphere, 8 pi eta R^3 Omega; the neighbours of a cubic array at phi = 0.027 add
// about phi to it. Catches a wrong lever arm or sign.
TEST_P(TurningSphere, FeelsTheStokesTorque) {
  const auto [scheme, model] = GetParam();  // model error: of a staircase three times its error in radius
  constexpr double radius = 4, rate = 1e-5;
  FixedSphere sphere(22, radius, Vec3(11.2, 10.9, 11), tau, scheme);
  sphere.beads[0].motion.angular_velocity = Vec3(0, 0, rate);
  Load impulse;
  for (int n = 0; n < 1500; ++n) impulse = sphere.step();
  const double stokes = -8 * pi * lattice_viscosity(tau) * std::pow(radius, 3) * rate;
  std::printf("%s: torque / Stokes = %.4f\n", to_text(scheme).c_str(), impulse.torque[2] / stokes);
  EXPECT_NEAR(impulse.torque[2] / stokes, 1.027, model);
  constexpr double off_centre = 0.01;  // force times radius over torque: the sphere is not at a cell's centre
  EXPECT_LT(impulse.force.norm() * radius, off_centre * std::abs(stokes));
}

}  // namespace
}  // namespace beadswim::test
