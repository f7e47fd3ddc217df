#include <gtest/gtest.h>

#include <cmath>

#include "bead_vectors.hpp"
#include "bispherical.hpp"
#include "scenes.hpp"
#include "thermal_noise.hpp"

// Thermal noise of swimmers without inertia, against exact means. Units: radius of a bead 1, viscosity such
// that a bead alone has the mobility 1, thermal energy 1. Each comparison states the standard error s of the
// mean and allows 4 s; seeds are fixed.

namespace beadswim {
namespace {

/// Returns swimmers of one type, with kT = 1.
OverdampedScene warm(const SwimmerType& type, const std::vector<Vec3>& positions, double step) {
  OverdampedScene scene;
  scene.viscosity = 1 / (6 * pi);
  scene.types = {type};
  for (std::size_t s = 0; s < positions.size(); ++s)
    scene.swimmers.push_back({.id = static_cast<int>(s), .type = 0, .position = positions[s]});
  scene.step = step;
  scene.tolerance = 1e-6;
  scene.thermal_energy = 1;
  scene.noise_tolerance = 1e-4;
  return scene;
}

SwimmerType sphere() {
  SwimmerType type;
  type.beads = {{{.radius = 1, .density = 1}, Vec3::Zero()}};
  type.driving.period = 1;
  return type;
}

/// Returns a dumbbell whose harmonic bond has the rest length l and the stiffness kT/(0.04 l^2).
SwimmerType dumbbell(double length, double stretch = 0.04) {
  SwimmerType type = sphere();
  type.beads = {{{.radius = 1, .density = 1}, Vec3(-length / 2, 0, 0)},
                {{.radius = 1, .density = 1}, Vec3(length / 2, 0, 0)}};
  type.bonds = {{{.stiffness = 1 / (stretch * length * length), .rest_length = length, .damping = 0}, {0, 1}}};
  return type;
}

/// Mean of correlated numbers, with the standard error by the means of blocks.
class BlockMean {
 public:
  explicit BlockMean(long block) : block_(block) {}
  void add(double number) {
    sum_ += number;
    if (++count_ % block_ != 0) return;
    means_.push_back(sum_ / static_cast<double>(block_));
    sum_ = 0;
  }
  double mean() const {
    double sum = 0;
    for (const double mean : means_) sum += mean;
    return sum / static_cast<double>(means_.size());
  }
  double standard_error() const {
    double square = 0;
    for (const double each : means_) square += (each - mean()) * (each - mean());
    const auto blocks = static_cast<double>(means_.size());
    return std::sqrt(square / (blocks * (blocks - 1)));
  }

 private:
  long block_, count_ = 0;
  double sum_ = 0;
  std::vector<double> means_;
};

void expect_mean(const BlockMean& mean, double exact, double largest_error, const std::string& what) {
  EXPECT_NEAR(mean.mean(), exact, 4 * mean.standard_error()) << what;
  EXPECT_LT(mean.standard_error(), largest_error) << what;
}

// Mean square displacement 6 D t. In a periodic cube of 50 radii, D is 0.943288 of that of a sphere alone.
TEST(ThermalNoise, DiffusesASphereAsItsMobilitySays) {
  const Communicator world(MPI_COMM_WORLD);
  for (const bool is_boxed : {false, true}) {
    OverdampedScene scene = warm(sphere(), {Vec3(25, 25, 25)}, 0.01);
    if (is_boxed) scene.domain.box = Box{.lengths = Vec3::Constant(50), .boundary = {}};
    OverdampedSystem system(scene, world);
    BlockMean square(100);
    const int steps = is_boxed ? 4000 : 40000;
    for (int n = 0; n < steps; ++n) {
      const Vec3 before = system.positions()[0];
      system.step();
      square.add((system.positions()[0] - before).squaredNorm() / (6 * scene.step));
    }
    expect_mean(square, is_boxed ? 0.943288 : 1, is_boxed ? 0.02 : 0.005, is_boxed ? "cube" : "open space");
  }
}

/// Returns the means of the distances of the beads of dumbbells, and of their squares, divided by the rest
/// length.
std::array<BlockMean, 2> distances(const OverdampedScene& scene, double length, long steps) {
  const Communicator world(MPI_COMM_WORLD);
  OverdampedSystem system(scene, world);
  const long ignored = steps / 50, swimmers = std::ssize(scene.swimmers);
  std::array<BlockMean, 2> means{BlockMean(ignored * swimmers), BlockMean(ignored * swimmers)};
  for (long n = 0; n < steps + ignored; ++n) {
    system.step();
    for (long s = 0; s < swimmers && n >= ignored; ++s) {
      const double r = (system.positions()[2 * s + 1] - system.positions()[2 * s]).norm() / length;
      means[0].add(r);
      means[1].add(r * r);
    }
  }
  EXPECT_FALSE(system.fault());
  return means;
}

// The weight of the distance r is r^2 exp(-k (r - l)^2/(2 kT)), whatever the mobility is.
TEST(ThermalNoise, StretchesADumbbellByItsWeight) {
  constexpr double length = 10;
  const auto [r, square] = distances(warm(dumbbell(length), {Vec3::Zero()}, 0.01), length, 1000000);
  expect_mean(r, 1.076923, 0.004, "distance");
  expect_mean(square, 1.196923, 0.009, "square");
}

// Over a wall towards which each bead is pulled by g, the weight has the further factor
// (1 - exp(-g r/kT))/(g r/kT).
TEST(ThermalNoise, StretchesADumbbellOverAWallByItsWeight) {
  constexpr double length = 10;
  SwimmerType type = dumbbell(length);
  type.driving.net_force = NetForce::allowed;
  for (const int bead : {0, 1})
    type.driving.forces.push_back(
        {.bead = bead, .direction = -Vec3::UnitZ(), .constant = 1 / length, .harmonics = {}});
  OverdampedScene scene =
      warm(type, {Vec3(0, 0, 8), Vec3(1000, 0, 8), Vec3(0, 1000, 8), Vec3(1000, 1000, 8)}, 2e-3);
  scene.domain.half_space = HalfSpace{.axis = 2};
  const auto [r, square] = distances(scene, length, 1000000);
  expect_mean(r, 1.061590, 0.006, "distance");
  expect_mean(square, 1.164157, 0.013, "square");
}

// Linear modes have their exact variance for every step h. The mean length of a bond is too large by about
// (h/2 tau) kT/(k l), because the rule sees the middle of a rotation.
TEST(ThermalNoise, GivesAStiffBondItsVarianceForEveryStep) {
  constexpr double length = 5, stretch = 1e-4;
  const double tau = stretch * length * length / 2;
  for (const double step : {0.1, 1.0, 10.0}) {
    const auto [r, square] =
        distances(warm(dumbbell(length, stretch), {Vec3::Zero()}, step * tau), length, 200000);
    EXPECT_NEAR(r.mean(), 1 + (2 + step / 2) * stretch, 0.5 * stretch + 4 * r.standard_error()) << step;
    const double variance = square.mean() - r.mean() * r.mean();
    EXPECT_NEAR(variance / stretch, 1, 0.04) << step;
  }
}

/// Returns the statistical weight of the repulsion between beads of radius 1, or of one with its mirror
/// image.
double contact_weight(double gap) {
  constexpr double d = 0.2, strength = 20 / d;
  if (gap >= d) return 1;
  if (gap < d / 20) return 0;
  return std::exp(-strength / 2 * (d * std::log(d / gap) - (d - gap)));
}

// Heights over a wall under the force -G: exp(-(G z + U)/kT), U: energy of the repulsion.
TEST(ThermalNoise, SpreadsSpheresOverAWallAsTheirWeightSays) {
  const Communicator world(MPI_COMM_WORLD);
  SwimmerType type = sphere();
  type.driving.net_force = NetForce::allowed;
  constexpr double G = 1;
  type.driving.forces.push_back({.bead = 0, .direction = -Vec3::UnitZ(), .constant = G, .harmonics = {}});
  OverdampedScene scene = warm(type, {Vec3(0, 0, 2)}, 2e-3);
  scene.domain.half_space = HalfSpace{.axis = 2};
  OverdampedSystem system(scene, world);
  double sum = 0, mean = 0;
  for (double z = 1; z < 40; z += 1e-4) {
    const double weight = std::exp(-G * z) * contact_weight(2 * (z - 1));
    sum += weight, mean += z * weight;
  }
  BlockMean height(20000);
  for (int n = 0; n < 1000000; ++n) {
    system.step();
    height.add(system.positions()[0].z());
  }
  EXPECT_FALSE(system.fault());
  expect_mean(height, mean / sum, 0.05, "height");
}

// Without forces all heights between free-slip walls are equally probable, outside of contacts. Without drift
// spheres would stay at the walls, where their mobility is 0.4 of that in the middle. The tested mean is that
// of cos(2 pi (z - 1)/4), which is 1 at contact with a wall and -1 in the middle.
TEST(ThermalNoise, SpreadsSpheresEvenlyBetweenFreeSlipWalls) {
  const Communicator world(MPI_COMM_WORLD);
  constexpr double height = 6;
  OverdampedScene scene = warm(sphere(), {{6, 6, 2}, {6, 18, 4}, {18, 6, 4}, {18, 18, 2}}, 4e-3);
  scene.domain.box = Box{.lengths = {24, 24, height},
                         .boundary = {Boundary::periodic, Boundary::periodic, Boundary::free_slip}};
  scene.tolerance = scene.noise_tolerance = 1e-3;
  OverdampedSystem system(scene, world);
  const auto wave = [](double z) { return std::cos(2 * pi * (z - 1) / (height - 2)); };
  double sum = 0, weighted = 0;
  for (double z = 1; z < height / 2; z += 1e-4) {
    const double weight = contact_weight(2 * (z - 1));
    sum += weight, weighted += weight * wave(z);
  }
  BlockMean mean(4000);
  for (int n = 0; n < 50000; ++n) {
    system.step();
    for (const Vec3& position : system.positions()) mean.add(wave(position.z()));
  }
  EXPECT_FALSE(system.fault());
  expect_mean(mean, weighted / sum, 0.04, "wave of heights");
}

// The squared displacement of two spheres along the line of their centres in a short time is 2 D t. D is kT
// times their relative mobility, of which rpy has a formula, and rpy+near the exact value.
TEST(ThermalNoise, MovesTwoSpheresApartAsTheirMobilitySays) {
  const Communicator world(MPI_COMM_WORLD);
  constexpr double r = 2.3;
  for (const MobilityModel model : {MobilityModel::rpy, MobilityModel::rpy_near}) {
    OverdampedScene scene = warm(sphere(), {Vec3::Zero(), Vec3(r, 0, 0)}, 1e-6);
    scene.model = model;
    BlockMean along(100), across(100);
    for (int n = 0; n < 8000; ++n) {
      scene.seed = n;
      OverdampedSystem system(scene, world);
      system.step();
      const Vec3 change = system.positions()[1] - system.positions()[0] - Vec3(r, 0, 0);
      along.add(change.x() * change.x() / (2 * scene.step));
      across.add((change.y() * change.y() + change.z() * change.z()) / (4 * scene.step));
    }
    const bool is_rpy = model == MobilityModel::rpy;
    const double inverse = 1 / (r * r * r);
    expect_mean(along, is_rpy ? 2 - 3 / r + 2 * inverse : 2 / approaching_spheres(r), 0.02, to_text(model));
    if (is_rpy) expect_mean(across, 2 - 1.5 / r - inverse, 0.02, "across");
  }
}

// The mean of random finite differences over many steps is the divergence of the mobility, here by central
// differences of its elements. In so long a step the noise itself is nothing beside it.
TEST(ThermalNoise, HasTheDivergenceOfTheMobility) {
  const Communicator world(MPI_COMM_WORLD);
  constexpr auto periodic = Boundary::periodic, free_slip = Boundary::free_slip;
  struct Case {
    std::string name;
    MobilityModel model = MobilityModel::rpy;
    Domain domain{};
    int order = 0;
  };
  const std::vector<Case> cases{
      {.name = "over a wall", .domain = {.box = {}, .half_space = HalfSpace{}}},
      {.name = "free-slip box",
       .domain = {.box = Box{.lengths = {14, 14, 12}, .boundary = {periodic, periodic, free_slip}}}},
      {.name = "rpy+near", .model = MobilityModel::rpy_near},
      {.name = "multipole",
       .model = MobilityModel::multipole,
       .domain = {.box = {}, .half_space = HalfSpace{}},
       .order = 1}};
  for (const auto& [name, model, domain, order] : cases) {
    OverdampedScene scene = warm(sphere(), {Vec3(5, 5, 1.7), Vec3(6.5, 6, 3.1)}, 1e8);
    scene.model = model;
    scene.domain = domain;
    scene.moment_order = order;
    const std::vector<double> radii{1, 1};
    const StepScene step{.scene = scene, .radii = radii, .communicator = world};
    const Beads places{scene.swimmers[0].position, scene.swimmers[1].position};
    scene.radii = radii;
    Mobility mobility(scene, places, world);
    MobilityRoot root(scene, places, 1e-3, mobility, world);
    Eigen::VectorXd exact = Eigen::VectorXd::Zero(6);
    constexpr double d = 1e-2;
    for (int k = 0; k < 6; ++k)
      for (const double sign : {-1.0, 1.0}) {
        Beads moved = places, force(2, Vec3::Zero()), velocities(2);
        moved[k / 3][k % 3] += sign * d;
        force[k / 3][k % 3] = sign / (2 * d);
        mobility.set_positions(moved);
        mobility.apply(force, velocities);
        exact += flat(velocities);
      }
    constexpr int samples = 3000;
    Eigen::MatrixXd drifts(6, samples);
    for (int n = 0; n < samples; ++n)
      drifts.col(n) = flat(thermal_noise(step, mobility, root, places, n).velocities);
    const Eigen::VectorXd mean = drifts.rowwise().mean();
    for (int k = 0; k < 6; ++k) {
      const double error =
          std::sqrt((drifts.row(k).array() - mean[k]).square().sum() / samples / (samples - 1));
      EXPECT_NEAR(mean[k], exact[k], 4 * error + 0.01 * exact.norm()) << name << ", " << k;
      EXPECT_LT(error, 0.1 * exact.norm()) << name;
    }
  }
}

TEST(ThermalNoise, IsAFunctionOfSeedStepAndBead) {
  const Communicator world(MPI_COMM_WORLD);
  const auto end = [&](std::uint64_t seed) {
    OverdampedScene scene = warm(dumbbell(10), {Vec3::Zero(), Vec3(0, 30, 0)}, 0.1);
    scene.seed = seed;
    OverdampedSystem system(scene, world);
    for (int n = 0; n < 5; ++n) system.step();
    return std::vector<Vec3>(system.positions().begin(), system.positions().end());
  };
  EXPECT_EQ(end(1), end(1));
  EXPECT_NE(end(1), end(2));
}

}  // namespace
}  // namespace beadswim
