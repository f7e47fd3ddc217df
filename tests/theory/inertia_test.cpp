#include "beadswim/theory/inertial_motion.hpp"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <cmath>
#include <functional>
#include <vector>

#include "beadswim/core/complex.hpp"
#include "lone_sphere_flow.hpp"
#include "scenes.hpp"
#include "space_integral.hpp"

namespace beadswim {
namespace {

constexpr double pi = std::numbers::pi;

// ---- A single bead

/// Returns a swimmer whose beads are so far apart that they do not affect each other.
CollinearSwimmer lone_beads(double period, double density) {
  CollinearSwimmer swimmer = with_density(paper_swimmer(period), density);
  swimmer.radius = {4, 3, 5};
  swimmer.arm = {1e9, 1e9};
  return swimmer;
}

double bead_mass(double radius, double density) {
  return 4 * pi / 3 * radius * radius * radius * density;
}

// F = Z U, Z = 6 pi eta a (1 + kappa + kappa^2/9) + i omega m: Stokes drag, Basset's force, added mass,
// bead's mass. Catches a displaced mass counted twice or not at all.
TEST(UnsteadyMobility, OfALoneBeadIsOneOverItsImpedance) {
  constexpr double roundoff = 1e-8;  // the others are 1e9 away
  for (const double density : {0.1, 1.0, 8.0}) {
    const CollinearSwimmer swimmer = lone_beads(700, density);
    const double omega = swimmer.angular_frequency(), eta = swimmer.viscosity;
    const Eigen::Matrix3cd mobility = unsteady_mobility(unbounded_scene(ask(swimmer)));
    for (int i = 0; i < 3; ++i) {
      const double a = swimmer.radius[i];
      const Complex kappa = std::sqrt(i_unit * omega / eta) * a;
      const Complex Z =
          6 * pi * eta * a * (1.0 + kappa + kappa * kappa / 9.0) + i_unit * omega * bead_mass(a, density);
      EXPECT_NEAR(std::abs(mobility(i, i) * Z - 1.0), 0, roundoff) << "density " << density;
    }
  }
}

/// Returns the velocity amplitude per unit force of a sphere that a force sin(omega t) drives. The sphere is
/// at rest at t = 0. Integrates the equation of Basset, Boussinesq and Oseen in time:
///   (m + m_fluid/2) dU/dt = sin(omega t) - 6 pi eta a U
///                           - 6 a^2 sqrt(pi eta rho) int_0^t U'(s)/sqrt(t - s) ds.
/// U is linear in each of the `steps` steps per period, and the history integral is exact for such a U. The
/// equation holds at the midpoints of steps. The result is the first harmonic of the last of `periods`
/// periods.
Complex basset_amplitude(double a, double eta, double rho, double density, double period, int steps,
                         int periods) {
  const double dt = period / steps, omega = 2 * pi / period;
  const double inertia = bead_mass(a, density) + bead_mass(a, rho) / 2;
  const double drag = 6 * pi * eta * a, history = 6 * a * a * std::sqrt(pi * eta * rho);
  const auto kernel = [dt](double age) { return 2 * std::sqrt(age * dt); };  // int ds/sqrt(s) from 0
  std::vector<double> acceleration;
  double velocity = 0;
  Complex amplitude = 0;
  for (int n = 0; n < steps * periods; ++n) {
    double memory = 0;
    for (int k = 0; k < n; ++k) memory += acceleration[k] * (kernel(n + 0.5 - k) - kernel(n - 0.5 - k));
    const double t = (n + 0.5) * dt;
    // At the midpoint U = velocity + dU/dt dt/2, and the current step has acted for half of itself.
    const double push = std::sin(omega * t) - drag * velocity - history * memory;
    acceleration.push_back(push / (inertia + drag * dt / 2 + history * kernel(0.5)));
    const double middle = velocity + acceleration.back() * dt / 2;
    velocity += acceleration.back() * dt;
    if (n >= steps * (periods - 1)) amplitude += 2.0 / steps * middle * std::exp(-i_unit * omega * t);
  }
  return amplitude / -i_unit;  // sin = Re(-i exp(i omega t))
}

TEST(UnsteadyMobility, OfALoneBeadIsThePeriodicStateOfBassetsEquation) {
  constexpr double truncation = 1e-3;  // steps of T/200, and what is left of the start after 6 periods
  const double period = 300, rho = 1;
  for (const double density : {0.1, 1.0, 8.0}) {
    const CollinearSwimmer swimmer = lone_beads(period, density);
    const Complex steady = unsteady_mobility(unbounded_scene(ask(swimmer)))(0, 0);
    const Complex in_time =
        basset_amplitude(swimmer.radius[0], swimmer.viscosity, rho, density, period, 200, 6);
    EXPECT_NEAR(std::abs(in_time / steady), 1, truncation) << "density " << density;
    EXPECT_NEAR(std::arg(in_time / steady), 0, truncation) << "density " << density;
  }
}

// ---- Three beads

// Reciprocity, and power that only goes into the fluid, for beads of any density.
TEST(UnsteadyMobility, IsSymmetricAndDissipates) {
  constexpr double roundoff = 1e-14;
  for (const double density : {0.01, 1.0, 20.0}) {
    for (const double period : {50.0, 1000.0, 1e6}) {
      CollinearSwimmer swimmer = with_density(unequal_swimmer(), density);
      swimmer.period = period;
      swimmer.arm = {9, 10};
      const Eigen::Matrix3cd mobility = unsteady_mobility(unbounded_scene(ask(swimmer)));
      EXPECT_LT((mobility - mobility.transpose()).norm() / mobility.norm(), roundoff);
      const Eigen::Matrix3d power = mobility.real();
      EXPECT_GT(power.selfadjointView<Eigen::Lower>().eigenvalues().minCoeff(), 0)
          << "density " << density << ", T = " << period;
    }
  }
}

// The beads' own mass adds i omega m to the impedance, whatever the fluid does.
TEST(UnsteadyMobility, TakesBeadsMassAsAnImpedance) {
  constexpr double roundoff = 1e-13;
  const CollinearSwimmer light = with_density(unequal_swimmer(), 0.3), heavy = with_density(light, 5);
  const Eigen::Matrix3cd difference = unsteady_mobility(unbounded_scene(ask(heavy))).inverse() -
                                      unsteady_mobility(unbounded_scene(ask(light))).inverse();
  Eigen::Matrix3cd masses = Eigen::Matrix3cd::Zero();
  for (int i = 0; i < 3; ++i)
    masses(i, i) = i_unit * light.angular_frequency() * bead_mass(light.radius[i], 5 - 0.3);
  EXPECT_LT((difference - masses).norm() / masses.norm(), roundoff * 1e3);
}

// ---- Limits

Question in_fluid_of_density(const CollinearSwimmer& swimmer, double density) {
  return ask(with_density(swimmer, density), density);
}

double ratio_to_steady(const Question& question) {
  return predicted("unsteady-response", question).velocity / predicted("rpy-perturbation", question).velocity;
}

// As the forces sum to zero, the uniform alpha/(6 pi eta) drops out, and what is left is of order alpha^2,
// that is of the density or the frequency: each tenth of it leaves a tenth. Catches a term without its limit.
void expect_first_order(const std::function<double(double)>& deviation, double finest) {
  constexpr double slope_tolerance = 0.02;
  for (const double size : {100 * finest, 10 * finest}) {
    EXPECT_NEAR(std::log10(deviation(size) / deviation(size / 10)), 1, slope_tolerance) << "at " << size;
  }
}

TEST(UnsteadyResponse, TendsToRotnePragerAsDensityVanishes) {
  const auto deviation = [](double density) {
    return ratio_to_steady(in_fluid_of_density(unequal_swimmer(), density)) - 1;
  };
  expect_first_order(deviation, 1e-6);
  EXPECT_LT(std::abs(deviation(1e-9)), 1e-9);  // with parts that cancel as 1/(alpha l)^2 = 1e6
}

TEST(UnsteadyResponse, TendsToRotnePragerForSlowDriving) {
  const auto deviation = [](double frequency) {
    CollinearSwimmer swimmer = unequal_swimmer();
    for (double& stiffness : swimmer.stiffness) stiffness *= frequency;  // the same stroke, slower
    swimmer.period /= frequency;
    return ratio_to_steady(ask(swimmer)) - 1;
  };
  expect_first_order(deviation, 1e-6);
  EXPECT_LT(std::abs(deviation(1e-6)), 2e-7);
}

TEST(UnsteadyResponse, TendsToRotnePragerInABoxAsDensityVanishes) {
  const Box walls{.lengths = {120, 70, 60},
                  .boundary = {Boundary::free_slip, Boundary::free_slip, Boundary::periodic}};
  for (const BoxPlace& place :
       {BoxPlace{periodic_box(128, 80, 80), {64, 40, 40}}, BoxPlace{walls, {50, 30, 20}}}) {
    const auto deviation = [&](double density) {
      Question question = in_fluid_of_density(unequal_swimmer(), density);
      question.surroundings.box = place;
      return predicted("unsteady-response", question).velocity /
                 predicted("rpy-box-perturbation", question).velocity -
             1;
    };
    expect_first_order(deviation, 1e-6);
    EXPECT_LT(std::abs(deviation(1e-6)), 2e-7);
  }
}

// The scallop theorem is one of no inertia: a swimmer with one rigid arm swims, in proportion to the density.
TEST(UnsteadyResponse, OfReciprocalStrokeIsOfTheOrderOfInertia) {
  CollinearSwimmer swimmer = unequal_swimmer();
  const double scale = predicted("rpy-perturbation", ask(swimmer)).velocity;
  swimmer.stiffness[1] = 1e9;
  swimmer.damping[1] = 0;
  const auto relative = [&](double density) {
    return predicted("unsteady-response", in_fluid_of_density(swimmer, density)).velocity / scale;
  };
  expect_first_order(relative, 1e-6);
  EXPECT_GT(std::abs(relative(1)), 0.05);
  EXPECT_LT(std::abs(relative(1e-6)), 1e-6);
}

// ---- Beads with mass in a fluid without

/// Returns the mean velocity in the last of `periods` periods by Newton's equations m dv/dt = F(t) - springs
/// - mu(x)^-1 v, integrated from rest by the classical Runge-Kutta method.
double newtonian_velocity(const CollinearSwimmer& swimmer, int steps, int periods) {
  using State = Eigen::Matrix<double, 6, 1>;
  const Eigen::Vector3cd driving = arm_rates().transpose() * driving_tensions(swimmer);
  const double omega = swimmer.angular_frequency(), dt = swimmer.period / steps;
  Eigen::Vector3d mass;
  for (int i = 0; i < 3; ++i) mass[i] = bead_mass(swimmer.radius[i], swimmer.density[i]);
  const auto rate = [&](double t, const State& state) {
    const Eigen::Vector3d x = state.head<3>(), v = state.tail<3>();
    Eigen::Vector3d force = (driving * std::polar(1.0, omega * t)).real();
    for (int arm = 0; arm < 2; ++arm) {
      const double pull = swimmer.stiffness[arm] * (x[arm + 1] - x[arm] - swimmer.arm[arm]) +
                          swimmer.damping[arm] * (v[arm + 1] - v[arm]);
      force[arm] += pull;
      force[arm + 1] -= pull;
    }
    const Eigen::Matrix3d mu =
        pairwise_mobility(rotne_prager, swimmer.radius, {x[0], x[1], x[2]}, swimmer.viscosity).value;
    State change;
    change << v, (force - mu.partialPivLu().solve(v)).cwiseQuotient(mass);
    return change;
  };
  const LinePositions rest = rest_positions(swimmer);
  State state;
  state << rest[0], rest[1], rest[2], 0, 0, 0;
  double start = 0;
  for (int n = 0; n < steps * periods; ++n) {
    if (n == steps * (periods - 1)) start = state.head<3>().mean();
    const double t = n * dt;
    const State k1 = rate(t, state), k2 = rate(t + dt / 2, state + dt / 2 * k1),
                k3 = rate(t + dt / 2, state + dt / 2 * k2), k4 = rate(t + dt, state + dt * k3);
    state += dt / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
  }
  return (state.head<3>().mean() - start) / swimmer.period;
}

// Only the beads have inertia: then the pairs are Rotne-Prager's and Newton's equations are the whole truth.
// Catches mass that is missing from the forces of second order.
TEST(UnsteadyResponse, OfHeavyBeadsInMasslessFluidSolvesNewtonsEquations) {
  constexpr double truncation =
      2e-5;  // steps, transients, amplitudes beyond second order after extrapolation
  for (const CollinearSwimmer& shape :
       {with_density(paper_swimmer(2000), 20), with_density(unequal_swimmer(), 8)}) {
    const Question question = ask(shape, 1e-9);
    const double predicted_velocity = predicted("unsteady-response", question).velocity;
    const auto simulated = [&](double amplitude) {
      return newtonian_velocity(with_amplitude(shape, amplitude), 1000, 14) / (amplitude * amplitude);
    };
    const double extrapolated = (4 * simulated(0.02) - simulated(0.04)) / 3;
    EXPECT_NEAR(predicted_velocity / extrapolated, 1, truncation);
    const double without_mass = predicted("rpy-perturbation", question).velocity;
    EXPECT_GT(std::abs(predicted_velocity / without_mass - 1), 0.02);  // so the masses do matter
  }
}

// ---- Invariance

/// Returns the change of the Reynolds stress by a uniform oscillation U along the axis: rho int <U u + u U> :
/// grad u^ dV.
double reynolds_change(const CollinearSwimmer& swimmer, const Eigen::Vector3cd& force, Complex uniform) {
  const LinePositions center = rest_positions(swimmer);
  const Complex alpha = inverse_penetration_depth(swimmer, 1);
  const Eigen::Vector3d towing = towing_forces(rest_mobility(swimmer, rotne_prager).value);
  return integral_over_space(swimmer, 2e4, 16, [&](double x, double s) {
    Eigen::RowVector2cd u = Eigen::RowVector2cd::Zero();
    Eigen::Matrix2d gradient = Eigen::Matrix2d::Zero();
    for (int i = 0; i < 3; ++i) {
      const double a = swimmer.radius[i], dx = x - center[i];
      u += force[i] * oscillating_sphere_flow(a, swimmer.viscosity, alpha, dx, s);
      gradient += towing[i] * towed_sphere_gradient(a, swimmer.viscosity, dx, s);
    }
    const double xx = 2 * (uniform * std::conj(u[0])).real() / 2;  // <U u_x + u_x U>
    const double xs = (uniform * std::conj(u[1])).real() / 2;
    return xx * gradient(0, 0) + xs * (gradient(0, 1) + gradient(1, 0));
  });
}

// A frame that shakes with neutral beads and fluid is none: what the beads' displacement adds to the drift,
// the Reynolds stress takes away. Both are 10 % of V here; a wrong mean (surface for Faxen's, steady for
// unsteady) in one of them breaks the balance.
TEST(UnsteadyResponse, DoesNotFeelACommonOscillationOfBeadsAndFluid) {
  constexpr double truncation = 2e-6;  // of the quadrature
  const Complex chi = std::polar(3.0, 0.7);
  for (const CollinearSwimmer& swimmer : {paper_swimmer(1000), paper_swimmer(4800), unequal_swimmer()}) {
    const InertialScene scene = unbounded_scene(ask(swimmer));
    LinearResponse response = linear_response(swimmer, unsteady_mobility(scene));
    const Eigen::Vector3cd force = induced_forces(scene, response);
    const double before = lagrangian_drift(scene, response);
    response.displacement.array() += chi;
    const double by_drift = lagrangian_drift(scene, response) - before;
    const double by_reynolds = reynolds_change(swimmer, force, i_unit * swimmer.angular_frequency() * chi);
    EXPECT_NEAR(by_reynolds / by_drift, -1, truncation);
  }
}

}  // namespace
}  // namespace beadswim
