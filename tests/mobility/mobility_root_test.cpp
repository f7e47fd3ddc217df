#include "beadswim/mobility/mobility_root.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>

#include "beadswim/core/keyed_random.hpp"
#include "grand_mobility.hpp"

// Root of the mobility. Units: viscosity 1, radius of the first sphere 1.

namespace beadswim {
namespace {

const std::vector<Vec3> places{{3, 4, 3.2}, {5.6, 4.1, 2.9}, {4, 6.6, 4.5}};

MobilityScene spheres(MobilityModel model, std::vector<double> radii) {
  MobilityScene scene;
  scene.model = model;
  scene.viscosity = 1;
  scene.radii = std::move(radii);
  scene.tolerance = 1e-6;
  scene.moment_order = model == MobilityModel::multipole ? 1 : 0;
  return scene;
}

Box box_with(const std::array<Boundary, 3>& boundary) {
  return {.lengths = Vec3(20, 21, 22), .boundary = boundary};
}

Eigen::VectorXd as_numbers(const std::vector<Vec3>& vectors) {
  return Eigen::Map<const Eigen::VectorXd>(vectors[0].data(), 3 * std::ssize(vectors));
}

Eigen::MatrixXd matrix_of(Mobility& mobility, std::size_t count) {
  const Eigen::Index size = 3 * static_cast<Eigen::Index>(count);
  Eigen::MatrixXd mu(size, size);
  std::vector<Vec3> velocities(count);
  for (Eigen::Index k = 0; k < size; ++k) {
    std::vector<Vec3> forces(count, Vec3::Zero());
    forces[k / 3][k % 3] = 1;
    mobility.apply(forces, velocities);
    mu.col(k) = as_numbers(velocities);
  }
  return (mu + mu.transpose()) / 2;
}

// The components of mu^(-1/2) B z are independent normal numbers: the means of their products over n samples
// have the standard errors sqrt(2/n) and sqrt(1/n). A missing part or a factor of two fails.
void expect_covariance(const MobilityScene& scene, const std::string& what,
                       const std::vector<Vec3>& at = places) {
  const Communicator world(MPI_COMM_WORLD);
  Mobility mobility(scene, at, world);
  MobilityRoot root(scene, at, 1e-4, mobility, world);
  const Eigen::MatrixXd whiten =
      Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(matrix_of(mobility, at.size())).operatorInverseSqrt();
  const int samples = scene.moment_order > 0 ? 400 : 2000;  // moments take 20 times as long
  Eigen::MatrixXd covariance = Eigen::MatrixXd::Zero(whiten.rows(), whiten.cols());
  for (int n = 0; n < samples; ++n) {
    const RootProduct product = root.at(at, n);
    ASSERT_TRUE(product.is_converged) << what;
    const Eigen::VectorXd white = whiten * as_numbers(product.velocities);
    covariance += white * white.transpose() / samples;
  }
  for (Eigen::Index i = 0; i < covariance.rows(); ++i)
    for (Eigen::Index j = 0; j <= i; ++j)
      EXPECT_NEAR(covariance(i, j), i == j, 4 * std::sqrt((i == j ? 2.0 : 1.0) / samples))
          << what << ", " << i << ", " << j;
}

TEST(MobilityRoot, GivesVelocitiesWhoseCovarianceIsTheMobility) {
  constexpr auto periodic = Boundary::periodic, free_slip = Boundary::free_slip;
  for (const MobilityModel model : {MobilityModel::rpy, MobilityModel::rpy_near, MobilityModel::multipole}) {
    MobilityScene scene = spheres(model, {1, 0.8, 1.3});
    expect_covariance(scene, "open space, " + to_text(model));
    scene.domain.box = box_with({periodic, periodic, periodic});
    if (model != MobilityModel::rpy_near) expect_covariance(scene, "periodic box, " + to_text(model));
    if (model != MobilityModel::rpy) continue;
    scene.domain.box = box_with({periodic, free_slip, free_slip});
    expect_covariance(scene, "box with mirrors");
    scene.radii = {1, 1, 1};
    expect_covariance(scene, "box with mirrors, equal spheres");
    scene.domain = {.box = {}, .half_space = HalfSpace{.axis = 2}};
    expect_covariance(scene, "over a wall");
    scene.domain = {.box = Box{.lengths = {5, 6, 7}, .boundary = {}}};
    expect_covariance(scene, "narrow box", {{1, 1, 1}, {3.5, 2, 2}, {2, 4, 5}});
  }
}

// Random overlapping spheres that fill half of the box, the hardest case. The sizes of eigenvalues are
// relative to the mobility of the largest sphere.
TEST(PositiveSplit, HasANearPartWithoutNegativeEigenvalues) {
  const Communicator world(MPI_COMM_WORLD);
  for (const double smaller : {1.0, 0.5}) {
    MobilityScene scene = spheres(MobilityModel::rpy, {});
    constexpr double edge = 14;
    scene.domain.box = Box{.lengths = Vec3::Constant(edge), .boundary = {}};
    scene.tolerance = 1e-3;
    std::vector<Vec3> at;
    KeyedRandom random(1, 2, 3);
    for (int b = 0; b < 320; ++b) {
      scene.radii.push_back(b % 2 == 0 ? 1 : smaller);
      at.emplace_back(edge * random.uniform(), edge * random.uniform(), edge * random.uniform());
    }
    const auto plan = root_plan(scene, at, world);
    ASSERT_TRUE(plan);
    GrandMobility split(scene, plan, world);
    split.set_positions(at);
    const Eigen::Index size = 3 * std::ssize(at);
    Eigen::MatrixXd near(size, size);
    for (Eigen::Index k = 0; k < size; ++k) {
      const Eigen::VectorXd force = Eigen::VectorXd::Unit(size, k);
      split.apply({force.data(), static_cast<std::size_t>(size)},
                  {near.col(k).data(), static_cast<std::size_t>(size)}, FlowPart::near);
    }
    const double xi = std::sqrt(plan->shape / 2) / plan->cutoff;  // of exp(-xi^2 r^2)
    const double smallest =
        Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(near, Eigen::EigenvaluesOnly).eigenvalues()[0];
    RecordProperty(fmt::format("smallest_{}", smaller),
                   fmt::format("{:.3g} at xi a = {:.3g}", smallest * 6 * std::numbers::pi, xi));
    EXPECT_GT(smallest * 6 * std::numbers::pi, -1e-3) << smaller << ", xi a = " << xi;
  }
}

TEST(MobilityRoot, HasTheErrorThatItStates) {
  const Communicator world(MPI_COMM_WORLD);
  MobilityScene scene = spheres(MobilityModel::rpy, {1, 0.8, 1.3});
  scene.domain.half_space = HalfSpace{.axis = 2};
  Mobility mobility(scene, places, world);
  MobilityRoot exact(scene, places, 1e-12, mobility, world);
  for (const double tolerance : {1e-1, 1e-2, 1e-3}) {
    MobilityRoot root(scene, places, tolerance, mobility, world);
    for (int n = 0; n < 20; ++n) {
      const RootProduct product = root.at(places, n);
      const Eigen::VectorXd expected = as_numbers(exact.at(places, n).velocities);
      EXPECT_LE(product.error, tolerance);
      EXPECT_LT((as_numbers(product.velocities) - expected).norm(), tolerance * expected.norm());
    }
  }
}

TEST(MobilityRoot, IsRefusedWhereTheMobilityIsNotPositive) {
  const Communicator world(MPI_COMM_WORLD);
  const MobilityScene scene = spheres(MobilityModel::oseen, {1, 1, 1});
  std::vector<Vec3> close = places;
  close[1] = close[0] + Vec3(0.8, 0, 0);
  Mobility mobility(scene, close, world);
  EXPECT_FALSE(MobilityRoot(scene, close, 1e-3, mobility, world).at(close, 1).is_converged);
}

}  // namespace
}  // namespace beadswim
