#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <complex>
#include <numbers>
#include <random>

#include "../collinear/oscillation.hpp"
#include "beadswim/collinear/oscillating_spheres.hpp"
#include "beadswim/core/error.hpp"
#include "beadswim/mobility/force_moments.hpp"
#include "beadswim/mobility/mobility.hpp"
#include "memory_field.hpp"

// Spheres in a fluid with memory, against sums over wavevectors, exact multipoles and laws.

namespace beadswim {
namespace {

constexpr double pi = std::numbers::pi;

class FluidMemoryTest : public testing::Test {
 protected:
  const Communicator world{MPI_COMM_WORLD};
};

/// Spheres of radius 1 in a periodic cube, on which forces along x act.
struct Spheres {
  double edge = 0;
  std::vector<Vec3> places;
  std::vector<double> forces;
  int order = 0;
  double spacing = 0.9;  ///< of the mesh of the Reynolds stress
  double omega = 1;      ///< with viscosity and density 1, a/delta = sqrt(omega/2)
  int steps = 100;       ///< per period
  std::vector<double> radii = std::vector<double>(places.size(), 1.0);

  MobilityScene scene(double step, double density = 1) const {
    return {.model = MobilityModel::unsteady,
            .viscosity = 1,
            .domain = {.box = Box{{edge, edge, edge}, {}}},
            .radii = radii,
            .tolerance = 1e-5,
            .moment_order = order,
            .memory = FluidMemory{
                .density = density, .step = step, .spacing = spacing, .has_reynolds_stress = false}};
  }
  std::vector<Vec3> forces_times(double factor) const {
    std::vector<Vec3> all;
    for (const double force : forces) all.push_back({factor * force, 0, 0});
    return all;
  }
};

/// Returns the complex velocities along x of spheres at rest positions under forces f cos(omega t), evaluated
/// in the fourth period.
std::vector<Complex> oscillating_velocities(const Spheres& s, const Communicator& world) {
  const double step = 2 * pi / s.omega / s.steps;
  Mobility product(s.scene(step), s.places, world);
  constexpr int periods = 4;
  std::vector<Complex> sums(s.places.size());
  std::vector<Vec3> velocities(s.places.size());
  product.start(s.forces_times(1));
  for (int n = 1; n <= periods * s.steps; ++n) {
    const double phase = 2 * pi * n / s.steps;
    const std::vector<Vec3> forces = s.forces_times(std::cos(phase));
    product.apply(forces, velocities, FlowPart::all);
    product.end_step(product.moments(), Vec3::Zero());
    for (std::size_t b = 0; b < sums.size() && n > (periods - 1) * s.steps; ++b)
      sums[b] += velocities[b][0] * std::polar(2.0 / s.steps, -phase);
  }
  return sums;
}

Spheres lone_sphere(double edge, double depth_ratio) {
  return {.edge = edge, .places = {{0.3, 0.2, 0.1}}, .forces = {1}, .omega = 2 * depth_ratio * depth_ratio};
}

/// Returns the velocity per force at order 0 of a sphere of radius 1 in a periodic cube: the sum over
/// wavevectors of j_0(k)^2/(k^2 + i omega), of which the steady part is the product without memory.
Complex exact_velocity(double edge, double omega, const Communicator& world) {
  const MobilityScene scene{.model = MobilityModel::rpy,
                            .viscosity = 1,
                            .domain = {.box = Box{{edge, edge, edge}, {}}},
                            .radii = {1},
                            .tolerance = 1e-8};
  const std::vector<Vec3> place{{0, 0, 0}}, force{{1, 0, 0}};
  std::vector<Vec3> velocity(1);
  Mobility(scene, place, world).apply(force, velocity);
  Complex sum = velocity[0][0];
  const double wave = 2 * pi / edge;
  const int n = static_cast<int>(12 / wave);  // the rest is below 1e-5
  for (int i = -n; i <= n; ++i) {
    for (int j = -n; j <= n; ++j) {
      for (int l = -n; l <= n; ++l) {
        const double k2 = wave * wave * (i * i + j * j + l * l), k = std::sqrt(k2);
        if (k2 == 0 || k > wave * n) continue;
        const double form = std::sin(k) / k;
        sum += 2.0 / 3 * form * form * (1.0 / (k2 + Complex(0, omega)) - 1 / k2) / std::pow(edge, 3);
      }
    }
  }
  return sum;
}

double relative_error(Complex value, Complex exact) {
  return std::abs(value / exact - 1.0);
}

TEST_F(FluidMemoryTest, OfALoneSphereIsTheSumOverWaves) {
  for (const auto& [depth_ratio, limit] : {std::pair{0.3, 5e-4}, {0.6, 2e-3}}) {
    const Spheres s = lone_sphere(16, depth_ratio);
    EXPECT_LT(relative_error(oscillating_velocities(s, world)[0], exact_velocity(s.edge, s.omega, world)),
              limit);
  }
  Spheres fast = lone_sphere(12, 1);
  fast.spacing = 0.75;
  EXPECT_LT(
      relative_error(oscillating_velocities(fast, world)[0], exact_velocity(fast.edge, fast.omega, world)),
      4e-3);
}

// The exact response of a rigid sphere is 1 + x + x^2/3, that of order 0 is 2x/(1 - e^-2x); x = sqrt(i
// omega).
TEST_F(FluidMemoryTest, OfALoneSphereAtOrderTwoIsCloserToTheExactResponse) {
  Spheres s = lone_sphere(10, 0.8);
  s.spacing = 0.8;
  s.steps = 50;
  const Complex x = alpha_of_modulus(std::sqrt(s.omega));
  const Complex exact = 1.0 + x + x * x / 3.0, of_order_0 = 2.0 * x / (1.0 - std::exp(-2.0 * x));
  const Complex first = oscillating_velocities(s, world)[0];
  s.order = 2;
  const Complex second = oscillating_velocities(s, world)[0];
  EXPECT_NEAR(relative_error(of_order_0, exact), 0.017, 0.001);
  EXPECT_LT(relative_error(second * exact, first * of_order_0), 0.002);
}

/// Returns the error of the difference of the velocities of two spheres on a line with opposite forces along
/// it, relative to exact multipoles in open space.
double pair_error(int order, double distance, double depth_ratio, const Communicator& world) {
  const Spheres pair{.edge = 20,
                     .places = {{10, 10, 10}, {10 + distance, 10, 10}},
                     .forces = {1, -1},
                     .order = order,
                     .omega = 2 * depth_ratio * depth_ratio,
                     .steps = 40};
  const std::vector<Complex> found = oscillating_velocities(pair, world);
  const std::vector<double> radii{1, 1}, on_line{0, distance};
  const OscillatingSpheres exact(radii, on_line, 1, alpha_of_modulus(std::sqrt(pair.omega)), 24);
  Eigen::MatrixXcd resistance = exact.resistance();
  resistance.diagonal().array() += Complex(0, pair.omega * 4 * pi / 3);  // of the fluid inside
  const Eigen::VectorXcd velocities = resistance.inverse() * Eigen::Vector2cd(1, -1);
  return relative_error(found[0] - found[1], velocities[0] - velocities[1]);
}

// In steady flow, the errors of orders 0, 1 and 2 decrease with the powers 4, 6 and 8 of a/r, or faster near
// contact. Errors of time steps and of the box are about 1e-3.
TEST_F(FluidMemoryTest, ConvergesToExactMultipolesOfTwoSpheres) {
  constexpr double near = 2.5, far = 3.2;
  constexpr std::array near_limits{0.3, 0.11, 0.035}, far_limits{0.04, 0.008, 0.004};
  for (int order = 0; order <= 2; ++order) {
    const double at_near = pair_error(order, near, 0.3, world), at_far = pair_error(order, far, 0.3, world);
    EXPECT_GT(std::log(at_near / at_far) / std::log(far / near), 4 + 2 * order);
    EXPECT_LT(at_near, near_limits[order]);
    EXPECT_LT(pair_error(order, far, 0.6, world), far_limits[order]);
  }
}

TEST_F(FluidMemoryTest, ConvergesInTimeWithTheSecondPower) {
  Spheres s = lone_sphere(12, 0.5);
  s.spacing = 0.6;
  const Complex exact = exact_velocity(s.edge, s.omega, world);
  double before = 0;
  for (const int steps : {25, 50, 100, 200}) {
    s.steps = steps;
    const double error = relative_error(oscillating_velocities(s, world)[0], exact);
    if (before > 0) {
      EXPECT_NEAR(before / error, 4, 1) << steps;
    }
    before = error;
  }
}

// The part of the flow that the mesh leaves out has the correct delay at low frequency, so that the error is
// of the fifth power of the spacing.
TEST_F(FluidMemoryTest, ConvergesInSpaceWithTheFifthPower) {
  Spheres s = lone_sphere(30, 0.6);
  s.steps = 25;
  s.spacing = 0.6;
  const Complex fine = oscillating_velocities(s, world)[0];
  double before = 0;
  for (const double spacing : {2.0, 1.4, 1.0}) {
    s.spacing = spacing;
    const double error = relative_error(oscillating_velocities(s, world)[0], fine);
    if (before > 0) {
      EXPECT_GT(before / error, 3) << spacing;
    }
    before = error;
  }
}

// An impulse I moves a sphere with v = I/(12 rho (pi nu t)^(3/2)), up to a share of 1/2 a^2/(nu t). The
// mode k = 0, which is missing, would add 2/3 I/(rho V).
TEST_F(FluidMemoryTest, AfterAnImpulseDecaysWithThePowerThreeHalves) {
  Spheres s = lone_sphere(60, 1);
  s.spacing = 2;
  constexpr double step = 0.25;
  Mobility product(s.scene(step), s.places, world);
  std::vector<Vec3> velocities(1);
  product.start(s.forces_times(0));
  for (int n = 1; n <= 141; ++n) {
    const std::vector<Vec3> forces = s.forces_times(n == 1 ? 1 : 0);
    product.apply(forces, velocities, FlowPart::all);
    product.end_step(product.moments(), Vec3::Zero());
    const double time = (n - 1) * step, law = step / (12 * std::pow(pi * time, 1.5));
    if (time < 5) continue;
    const double in_open_space = velocities[0][0] + 2.0 / 3 * step / std::pow(s.edge, 3);
    EXPECT_NEAR(in_open_space / law, 1 - 0.5 / time, 0.1 / time) << time;
  }
}

/// Spheres of random radii at random places in a cube.
Spheres random_spheres(int count, double edge) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> uniform(0, 1);
  Spheres s{.edge = edge, .places = {}, .forces = {}};
  for (int b = 0; b < count; ++b) {
    s.places.push_back(edge * Vec3(uniform(random), uniform(random), uniform(random)));
    s.forces.push_back(uniform(random) - 0.5);
    s.radii.push_back(0.6 + 0.6 * uniform(random));
  }
  return s;
}

TEST_F(FluidMemoryTest, WithoutDensityIsSteadyFlow) {
  Spheres s = random_spheres(6, 10);
  for (const int order : {0, 1, 2}) {
    s.order = order;
    Mobility steady(s.scene(0.1, 0), s.places, world);
    Mobility light(s.scene(0.1, 1e-15), s.places, world);
    std::vector<Vec3> expected(6), found(6);
    light.start(s.forces_times(1));
    light.apply(s.forces_times(-2), found, FlowPart::all);
    light.end_step(light.moments(), Vec3::Zero());
    steady.apply(s.forces_times(1), expected);
    light.apply(s.forces_times(1), found, FlowPart::all);
    // With higher moments, the iteration begins elsewhere.
    const double limit = order == 0 ? 1e-13 : 1e-5;
    for (int b = 0; b < 6; ++b) EXPECT_LT((found[b] - expected[b]).norm(), limit * expected[b].norm());
  }
}

// A box with free-slip walls is half of a periodic box with mirror images.
TEST_F(FluidMemoryTest, OfAWallIsThatOfTheMirrorImages) {
  for (const int order : {0, 1}) {
    Spheres half = random_spheres(4, 10), whole = half;
    half.order = whole.order = order;
    for (int b = 0; b < 4; ++b) {
      whole.places.push_back({half.places[b][0], -half.places[b][1], half.places[b][2]});
      whole.forces.push_back(half.forces[b]);
      whole.radii.push_back(half.radii[b]);
    }
    MobilityScene walled = half.scene(0.2), periodic = whole.scene(0.2);
    walled.domain.box = Box{{10, 10, 10}, {Boundary::periodic, Boundary::free_slip, Boundary::periodic}};
    periodic.domain.box = Box{{10, 20, 10}, {}};
    for (MobilityScene* scene : {&walled, &periodic}) scene->memory->has_reynolds_stress = true;
    Mobility in_half(walled, half.places, world), in_whole(periodic, whole.places, world);
    in_half.start(half.forces_times(0));
    in_whole.start(whole.forces_times(0));
    std::vector<Vec3> found(4), expected(8);
    for (int n = 1; n <= 3; ++n) {
      in_half.apply(half.forces_times(n), found, FlowPart::all);
      in_whole.apply(whole.forces_times(n), expected, FlowPart::all);
      in_half.end_step(in_half.moments(), Vec3::Zero());
      in_whole.end_step(in_whole.moments(), Vec3::Zero());
    }
    for (int b = 0; b < 4; ++b) EXPECT_LT((found[b] - expected[b]).norm(), 2e-5 * expected[b].norm());
  }
}

/// A flow in a periodic cube of edge 2 pi, as modes of a MemoryField, in which no forces act.
struct ModeFlow {
  static constexpr int points = 24;
  static constexpr double step = 0.1, density = 1.7, viscosity = 0.3;
  const std::vector<double> no_windows = std::vector<double>(points / 2 + 1, 1.0);
  MeshTransform transform;
  MemoryField field{
      {.density = density, .step = step, .spacing = 2 * pi / points, .has_reynolds_stress = true},
      {.viscosity = viscosity, .radii = {1}, .lengths = Vec3::Constant(2 * pi)},
      {points, points, points},
      {no_windows, no_windows, no_windows},
      transform};

  explicit ModeFlow(const Communicator& world)
      : transform({points, points, points}, {points, points, points}, world) {}

  template <class Visitor>
  void for_each_mode(const Visitor& visit) const {
    int mode = 0;
    transform.for_each_wave([&](std::ptrdiff_t, int i, int j, int l) {
      const Vec3 k(i, j, l);
      if (k.norm() > 0 && k.norm() <= field.cutoff()) visit(mode++, k);
    });
  }
  /// Sets the flow to the function u(k) of the wavevector, ends a step and returns the Reynolds stress.
  template <class Flow>
  std::vector<Eigen::Vector3cd> stress_of(const Flow& flow, const Vec3& mean_flow) {
    std::vector<double> state(field.state().size(), 0.0);
    for_each_mode([&](int mode, const Vec3& k) {
      const Eigen::Vector3cd u = flow(k);
      for (int c = 0; c < 3; ++c) {
        state[12 * mode + 2 * c] = u[c].real();
        state[12 * mode + 2 * c + 1] = u[c].imag();
      }
    });
    field.restore(state);
    field.end_step(mean_flow);
    const std::vector<double> after = field.state();
    std::vector<Eigen::Vector3cd> stresses;
    for_each_mode([&](int mode, const Vec3& k) {
      const StepFactors factors = step_factors(viscosity / density * k.squaredNorm() * step);
      Eigen::Vector3cd stress;
      for (int c = 0; c < 3; ++c) {
        const int at = 12 * mode + 2 * c;
        const Complex change(after[at] - factors.decay * state[at],
                             after[at + 1] - factors.decay * state[at + 1]);
        stress[c] = density / step * change / (factors.delay + factors.ramp);
      }
      stresses.push_back(stress);
    });
    return stresses;
  }
};

/// Coefficient of exp(i k x) in sin(m y), for wavevectors along y.
Complex sine(double k, double m) {
  return k == m ? Complex(0, -0.5) : k == -m ? Complex(0, 0.5) : 0;
}
/// Coefficient in cos(m y).
double cosine(double k, double m) {
  return std::abs(k) == std::abs(m) ? 0.5 : 0;
}

// u = (A sin my, B sin nx, 0) has the Reynolds stress (dpsi/dy, -dpsi/dx, 0) up to a gradient, with
// psi = -rho A B (m^2 - n^2)/(m^2 + n^2) sin nx sin my. A mean flow V along y adds (-rho V A m cos my, 0, 0).
TEST_F(FluidMemoryTest, HasTheReynoldsStressOfCrossingShearFlows) {
  constexpr double A = 0.7, B = -1.2, V = 0.4;
  constexpr int m = 3, n = 5;
  ModeFlow box(world);
  const auto flow = [&](const Vec3& k) {
    Eigen::Vector3cd u = Eigen::Vector3cd::Zero();
    if (k[0] == 0 && k[2] == 0) u[0] = A * sine(k[1], m);
    if (k[1] == 0 && k[2] == 0) u[1] = B * sine(k[0], n);
    return u;
  };
  const std::vector<Eigen::Vector3cd> stresses = box.stress_of(flow, {0, V, 0});
  constexpr double psi = -ModeFlow::density * A * B * (m * m - n * n) / (m * m + n * n);
  box.for_each_mode([&](int mode, const Vec3& k) {
    Eigen::Vector3cd expected = Eigen::Vector3cd::Zero();
    if (k[2] == 0) {
      expected[0] = psi * m * sine(k[0], n) * cosine(k[1], m);
      expected[1] = -psi * n * cosine(k[0], n) * sine(k[1], m);
      if (k[0] == 0) expected[0] -= ModeFlow::density * V * A * m * cosine(k[1], m);
    }
    EXPECT_LT((stresses[mode] - expected).norm(), 1e-13) << k.transpose();
  });
}

// The vortex u = (sin x cos y, -cos x sin y, 0) obeys the Navier-Stokes equation without Reynolds stress.
TEST_F(FluidMemoryTest, HasNoReynoldsStressInAVortexOfTaylorAndGreen) {
  ModeFlow box(world);
  const std::vector<Eigen::Vector3cd> stresses = box.stress_of(
      [](const Vec3& k) {
        if (k[2] != 0) return Eigen::Vector3cd(0, 0, 0);
        return Eigen::Vector3cd(sine(k[0], 1) * cosine(k[1], 1), -cosine(k[0], 1) * sine(k[1], 1), 0);
      },
      Vec3::Zero());
  for (const Eigen::Vector3cd& stress : stresses) EXPECT_LT(stress.norm(), 1e-14);
}

// Without positive definite mobilities, time steps would be unstable.
TEST_F(FluidMemoryTest, HasAPositiveDefiniteMobilityOfBeadsInContact) {
  for (const int order : {1, 2}) {
    for (const double diffusion : {0.01, 0.1, 1.0}) {  // nu h/a^2
      Spheres chain{.edge = 24, .places = {{5, 5, 5}, {7, 5, 5}, {9, 5, 5}}, .forces = {}, .order = order};
      MobilityScene scene = chain.scene(diffusion);
      scene.tolerance = 1e-4;
      Mobility product(scene, chain.places, world);
      const int size = 3 * moment_count(order);
      Eigen::MatrixXd mobility(size, size);
      for (int m = 0; m < size; ++m) {
        const Eigen::VectorXd moments = Eigen::VectorXd::Unit(size, m);
        product.project_flow_of({moments.data(), moments.data() + size},
                                {mobility.col(m).data(), mobility.col(m).data() + size});
      }
      const Eigen::VectorXd scale = mobility.diagonal().cwiseSqrt().cwiseInverse();
      const Eigen::MatrixXd scaled = scale.asDiagonal() * mobility * scale.asDiagonal();
      EXPECT_LT((scaled - scaled.transpose()).norm(), 1e-3);
      const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver((scaled + scaled.transpose()) / 2);
      EXPECT_GT(solver.eigenvalues()[0], 0) << "order " << order << ", nu h/a^2 " << diffusion;
    }
  }
}

TEST_F(FluidMemoryTest, NeedsABox) {
  Spheres s = lone_sphere(10, 0.5);
  MobilityScene scene = s.scene(0.1);
  scene.domain.box.reset();
  EXPECT_THROW(Mobility(scene, s.places, world), InputError);
}

}  // namespace
}  // namespace beadswim
