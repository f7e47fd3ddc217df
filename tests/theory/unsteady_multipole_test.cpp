#include "beadswim/theory/unsteady_multipole.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>

#include "beadswim/core/complex.hpp"
#include "beadswim/theory/linear_response.hpp"
#include "outside_nodes.hpp"
#include "scenes.hpp"

namespace beadswim {
namespace {

constexpr double pi = std::numbers::pi;

/// Returns the motion at a resolution, in fluid of density `rho`.
ExactMotion motion_of(const CollinearSwimmer& swimmer, double rho, const MultipoleResolution& resolution) {
  return exact_motion(unsteady_multipoles(swimmer, rho, resolution), swimmer);
}

ExactMotion motion_of(const CollinearSwimmer& swimmer, double rho = 1) {
  return motion_of(swimmer, rho, sufficient_resolution(swimmer).value());
}

// ---- Quadrature outside of spheres

// r^-6 outside of one sphere, and outside of two spheres by their own integrals in closed form: the integral
// of r^-6 around sphere 1 over the inside of sphere 2 (radius b, distance d) is 4 pi b^3/(3 (d^2 - b^2)^3).
TEST(OutsideNodes, IntegratePowersOfTheDistance) {
  constexpr double quadrature = 1e-8;
  constexpr std::array radii{1.5, 0.7}, positions{-1.0, 2.3};
  const double d = positions[1] - positions[0], b = radii[1];
  for (const double depth : {0.3, 5.0, 1e4}) {
    double sum = 0;
    for (const auto& [x, s, weight] : outside_nodes(radii, positions, depth, 10)) {
      sum += weight * std::pow(std::hypot(x - positions[0], s), -6);
    }
    const double whole = 4 * pi / (3 * std::pow(radii[0], 3));
    const double hidden = 4 * pi * std::pow(b, 3) / (3 * std::pow(d * d - b * b, 3));
    EXPECT_NEAR(sum / (whole - hidden), 1, quadrature) << "depth " << depth;
  }
}

// ---- Mean forces

/// Returns for each towed sphere k the matrix of the elements -rho int u^k . (u_i* . grad u_j) dV, the
/// Reynolds stress in another form.
std::vector<Eigen::MatrixXcd> reynolds_by_acceleration(const OscillatingSpheres& unsteady,
                                                       const OscillatingSpheres& steady,
                                                       const CollinearSwimmer& swimmer, double rho) {
  const LinePositions positions = rest_positions(swimmer);
  const double depth = std::sqrt(2.0) / std::abs(unsteady.alpha());
  std::vector<Eigen::MatrixXcd> forms(3, Eigen::MatrixXcd::Zero(3, 3));
  for (const auto& [x, s, weight] : outside_nodes(swimmer.radius, positions, depth, 9)) {
    const FlowAtPoint u = unsteady.at(x, s);
    const Eigen::Matrix2Xcd towed = steady.at(x, s).velocity;
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j) {
        const Complex along_x =
            std::conj(u.velocity(0, j)) * u.gradient(0, i) + std::conj(u.velocity(1, j)) * u.gradient(2, i);
        const Complex along_s =
            std::conj(u.velocity(0, j)) * u.gradient(1, i) + std::conj(u.velocity(1, j)) * u.gradient(3, i);
        for (int k = 0; k < 3; ++k) {
          forms[k](i, j) -= rho * weight * (towed(0, k).real() * along_x + towed(1, k).real() * along_s);
        }
      }
    }
  }
  return forms;
}

// The two forms of the Reynolds stress differ by integrals over the surfaces, which vanish only for the exact
// flow and with no part of space missing.
TEST(MeanForces, AgreeInTwoFormsOfTheReynoldsStress) {
  constexpr double agreement = 1e-6;
  for (const CollinearSwimmer& swimmer : {paper_swimmer(1000), unequal_swimmer()}) {
    const LinePositions positions = rest_positions(swimmer);
    const OscillatingSpheres unsteady(swimmer.radius, positions, swimmer.viscosity,
                                      inverse_penetration_depth(swimmer, 1), 10);
    const OscillatingSpheres steady(swimmer.radius, positions, swimmer.viscosity, 0, 10);
    const double omega = swimmer.angular_frequency();
    const MeanForces forces = mean_forces(unsteady, steady, swimmer.viscosity, omega, 9);
    const auto other = reynolds_by_acceleration(unsteady, steady, swimmer, 1);
    const Eigen::Vector3cd velocity = Complex(0, omega) * motion_of(swimmer).response.displacement;
    for (int k = 0; k < 3; ++k) {
      const Eigen::VectorXcd sizes = velocity.cwiseAbs().cast<Complex>();
      const double size = mean_of(forces.reynolds[k].cwiseAbs().cast<Complex>(), sizes, sizes);
      EXPECT_NEAR(mean_of(forces.reynolds[k], velocity, velocity), mean_of(other[k], velocity, velocity),
                  agreement * size);
    }
  }
}

// Steady streaming around a fast sphere: far away on its axis a small free sphere drifts at (45/16) U^2
// a/(omega l^2) (boundary-layer theory). The deviation is of first order in 1/kappa; three values of kappa
// extrapolate to zero.
TEST(MeanForces, DriveSteadyStreamingAtHighFrequency) {
  constexpr double distance = 100, omega = 1, viscosity = 1;
  constexpr std::array radii{1.0, 0.2}, positions{0.0, distance};
  const auto drift_at = [&](double kappa) {
    const double rho = kappa * kappa * viscosity / omega;
    const OscillatingSpheres unsteady(radii, positions, viscosity, std::polar(kappa, pi / 4), 8);
    const OscillatingSpheres steady(radii, positions, viscosity, 0, 8);
    const MeanForces forces = mean_forces(unsteady, steady, viscosity, omega, 8);
    const Eigen::MatrixXcd& z = unsteady.resistance();
    const Complex mass(0, omega * rho * 4 * pi / 3 * std::pow(radii[1], 3));
    const Eigen::Vector2cd velocity(1, -z(1, 0) / (z(1, 1) + mass));
    const double force =
        mean_of(forces.drift[1], velocity, velocity) + mean_of(forces.reynolds[1], velocity, velocity);
    return force / forces.resistance(1, 1) * omega * distance * distance;
  };
  const double coarse = drift_at(100), middle = drift_at(200), fine = drift_at(400);
  const double first = 2 * middle - coarse, second = 2 * fine - middle;
  EXPECT_NEAR((4 * second - first) / 3, 45.0 / 16, 0.005 * 45 / 16);
}

// ---- Swimmers

// Without inertia it is the exact steady theory, which differentiates mobilities by positions.
TEST(UnsteadyMultipole, TendsToExactStokesFlowAsDensityVanishes) {
  constexpr double density = 1e-16, tolerance = 1e-6;
  for (const CollinearSwimmer& shape : {paper_swimmer(4800), unequal_swimmer()}) {
    const CollinearSwimmer swimmer = with_density(shape, density);
    const PeriodicMotion exact =
        second_order_motion(swimmer, exact_mobility(swimmer, rest_positions(swimmer)));
    const ExactMotion motion = motion_of(swimmer, density);
    EXPECT_NEAR(motion.mean.velocity() / exact.velocity, 1, tolerance);
    for (int arm = 0; arm < 2; ++arm) {
      EXPECT_NEAR(motion.mean.arm_changes[arm] / exact.arm_changes[arm], 1, tolerance);
      EXPECT_NEAR(std::abs(motion.response.arm[arm]) / exact.stroke.amplitude[arm], 1, tolerance);
    }
  }
}

// More multipoles and nodes: the errors that the header states, and beads that nearly touch.
TEST(UnsteadyMultipole, HasTheStatedError) {
  struct Case {
    double arm, period, stated;
    MultipoleResolution fine;
  };
  for (const auto& [arm, period, stated, fine] : {Case{20, 1000, 1e-8, {.order = 20, .nodes = 12}},
                                                  {10, 10000, 1e-8, {.order = 32, .nodes = 12}},
                                                  {9, 2000, 1e-7, {.order = 48, .nodes = 8}}}) {
    SCOPED_TRACE(testing::Message() << "arm " << arm);
    CollinearSwimmer swimmer = paper_swimmer(period);
    swimmer.arm = {arm, arm};
    const MultipoleResolution resolution = sufficient_resolution(swimmer).value();
    const double exact = motion_of(swimmer, 1, fine).mean.velocity();
    const double error = std::abs(motion_of(swimmer, 1, resolution).mean.velocity() / exact - 1);
    const double coarse = std::abs(motion_of(swimmer, 1, coarser(resolution)).mean.velocity() / exact - 1);
    EXPECT_LT(error, stated);
    EXPECT_LT(error, coarse);
  }
}

// A mirror image swims the other way; another unit of length, mass and time changes nothing.
TEST(UnsteadyMultipole, ObeysSymmetries) {
  constexpr double roundoff = 1e-9;
  const CollinearSwimmer swimmer = unequal_swimmer();
  const double velocity = motion_of(swimmer).mean.velocity();
  EXPECT_NEAR(motion_of(mirrored(swimmer)).mean.velocity() / velocity, -1, roundoff);

  constexpr double length = 3, mass = 7, time = 0.2;
  const CollinearSwimmer other = in_units(swimmer, length, time, mass);
  EXPECT_NEAR(motion_of(other, other.density[0]).mean.velocity() / velocity, length / time,
              roundoff * length / time);
}

// A swimmer that equals its mirror image goes nowhere.
TEST(UnsteadyMultipole, GoesNowhereByASymmetricStroke) {
  CollinearSwimmer swimmer = paper_swimmer(2000);
  const double velocity = motion_of(swimmer).mean.velocity();
  swimmer.phase = 0;  // both arms move alike: mirror symmetry
  EXPECT_LT(std::abs(motion_of(swimmer).mean.velocity()), 1e-10 * velocity);
}

TEST(UnsteadyMultipole, RefusesBeadsThatNearlyTouch) {
  CollinearSwimmer swimmer = paper_swimmer(2000);
  swimmer.arm = {8.1, 20};
  EXPECT_FALSE(sufficient_resolution(swimmer));
  EXPECT_EQ(
      obstacle(find_method("unsteady-multipole"), ask(swimmer)),
      "beads nearly touch at rest (separation ratio l/lambda = 2.025), and the flow would need more than 100 "
      "multipoles per bead; use the less accurate method unsteady-response");
}

}  // namespace
}  // namespace beadswim
