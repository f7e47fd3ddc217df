#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <random>
#include <utility>

#include "beadswim/core/error.hpp"
#include "beadswim/mobility/mobility.hpp"
#include "beadswim/mobility/wall_map.hpp"
#include "sphere_surfaces.hpp"

// Mobility of spheres over a plane no-slip wall and in a linear background flow, against Blake's tensor,
// exact solutions and limits.

namespace beadswim {
namespace {

constexpr double pi = std::numbers::pi, viscosity = 0.7;

struct Spheres {
  std::vector<double> radii;
  std::vector<Vec3> places;
};

MobilityScene over_wall(MobilityModel model, const Spheres& spheres, int order = 0, int axis = 2) {
  return {.model = model,
          .viscosity = viscosity,
          .domain = {.box = {}, .half_space = HalfSpace{axis}},
          .radii = spheres.radii,
          .tolerance = 1e-12,
          .moment_order = order};
}

std::vector<Vec3> velocities(const MobilityScene& scene, const Spheres& spheres,
                             const std::vector<Vec3>& forces) {
  const Communicator self(MPI_COMM_SELF);
  Mobility product(scene, spheres.places, self);
  std::vector<Vec3> result(forces.size());
  EXPECT_TRUE(product.apply(forces, result, FlowPart::all).is_converged);
  return result;
}

/// Returns the matrix from all forces to all velocities.
Eigen::MatrixXd mobility(const MobilityScene& scene, const Spheres& spheres) {
  const Eigen::Index size = 3 * std::ssize(spheres.radii);
  Eigen::MatrixXd matrix(size, size);
  for (Eigen::Index k = 0; k < size; ++k) {
    std::vector<Vec3> forces(spheres.radii.size(), Vec3::Zero());
    forces[k / 3][k % 3] = 1;
    const std::vector<Vec3> v = velocities(scene, spheres, forces);
    matrix.col(k) = Eigen::Map<const Eigen::VectorXd>(v[0].data(), size);
  }
  return matrix;
}

/// Flow at x of a point force at y over a wall at z = 0: Blake's tensor [time/mass].
Eigen::Matrix3d blake_tensor(const Vec3& x, const Vec3& y) {
  const Vec3 r = x - y, R(x[0] - y[0], x[1] - y[1], x[2] + y[2]);
  const double d = r.norm(), D = R.norm(), h = y[2];
  Eigen::Matrix3d G;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      const double same = i == j ? 1 : 0;
      G(i, j) = same / d + r[i] * r[j] / (d * d * d) - same / D - R[i] * R[j] / (D * D * D);
      // 2 h (+-) d/dR_j { h R_i/R^3 - (delta_i3/R + R_i R_3/R^3) }, with - for j = 3
      const double source = h * (same / std::pow(D, 3) - 3 * R[i] * R[j] / std::pow(D, 5));
      const double along_3 = i == 2 ? -R[j] / std::pow(D, 3) : 0.0;
      const double stokeslet = along_3 + (same * R[2] + (j == 2 ? R[i] : 0.0)) / std::pow(D, 3) -
                               3 * R[i] * R[2] * R[j] / std::pow(D, 5);
      G(i, j) += (j == 2 ? -2 : 2) * h * (source - stokeslet);
    }
  }
  return G / (8 * pi * viscosity);
}

TEST(HalfSpace, FlowOfPointForcesIsBlakesTensor) {
  const Spheres spheres{.radii = {0.3, 0.5}, .places = {{0.2, -0.1, 0.9}, {1.4, 0.7, 0.35}}};
  const Eigen::MatrixXd found = mobility(over_wall(MobilityModel::oseen, spheres), spheres);
  EXPECT_LT((found.block<3, 3>(0, 3) - blake_tensor(spheres.places[0], spheres.places[1])).norm(), 1e-14);
  EXPECT_LT((found.block<3, 3>(3, 0) - blake_tensor(spheres.places[1], spheres.places[0])).norm(), 1e-14);
  for (int b = 0; b < 2; ++b) {  // -9/(16 H) along the wall, -9/(8 H) across it
    const double stokes = 1 / (6 * pi * viscosity * spheres.radii[b]);
    const double near = spheres.radii[b] / spheres.places[b][2];
    EXPECT_NEAR(found(3 * b, 3 * b), stokes * (1 - 9 * near / 16), 1e-14);
    EXPECT_NEAR(found(3 * b + 2, 3 * b + 2), stokes * (1 - 9 * near / 8), 1e-14);
  }
}

// Swan & Brady (2007).
TEST(HalfSpace, MobilityOfOneSphereOfFiniteSizeIsThatOfTheFormula) {
  const double a = 0.8, stokes = 1 / (6 * pi * viscosity * a);
  for (const int axis : {0, 1, 2}) {
    for (const double H : {1.0, 1.1, 2.0, 5.0, 40.0}) {
      const Spheres sphere{.radii = {a}, .places = {Vec3(0.3, -2, 1)}};
      Spheres placed = sphere;
      placed.places[0][axis] = H * a;
      const Eigen::MatrixXd found = mobility(over_wall(MobilityModel::rpy, placed, 0, axis), placed);
      for (int c = 0; c < 3; ++c) {
        const double expected = c == axis ? 1 - (9 / H - 4 / std::pow(H, 3) + 1 / std::pow(H, 5)) / 8
                                          : 1 - (9 / H - 2 / std::pow(H, 3) + 1 / std::pow(H, 5)) / 16;
        EXPECT_NEAR(found(c, c) / stokes, expected, 1e-14) << axis << c << H;
        EXPECT_NEAR(found(c, (c + 1) % 3) / stokes, 0, 1e-15);
      }
    }
  }
}

class HalfSpaceOrder : public testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(Orders, HalfSpaceOrder, testing::Values(0, 1, 2));

/// Returns the matrix from all moments to all projections of several spheres over a wall.
Eigen::MatrixXd moment_matrix(int order, const Spheres& spheres, int axis = 2) {
  const Communicator self(MPI_COMM_SELF);
  Mobility product(over_wall(MobilityModel::multipole, spheres, order, axis), spheres.places, self);
  const Eigen::Index size = moment_count(order) * std::ssize(spheres.radii);
  Eigen::MatrixXd matrix(size, size);
  for (Eigen::Index k = 0; k < size; ++k) {
    std::vector<double> moments(size, 0.0);
    moments[k] = 1;
    product.project_flow_of(moments, {matrix.col(k).data(), static_cast<std::size_t>(size)});
  }
  return matrix;
}

// Catches a wrong derivative, sign or size factor in the reflection.
TEST_P(HalfSpaceOrder, FlowOfMomentsIsTheIntegralOverBothSurfaces) {
  const int order = GetParam(), count = moment_count(order);
  const Spheres spheres{.radii = {0.7, 0.4}, .places = {{0.1, 0.2, 0.9}, {2.1, -0.7, 0.5}}};
  const Eigen::MatrixXd found = moment_matrix(order, spheres);
  const std::vector<SurfaceNode> nodes = sphere_nodes(16);
  Eigen::MatrixXd expected = Eigen::MatrixXd::Zero(count, count);
  for (const SurfaceNode& p : nodes) {
    for (const SurfaceNode& q : nodes) {
      const Vec3 x = spheres.places[0] + spheres.radii[0] * p.normal;
      const Vec3 y = spheres.places[1] + spheres.radii[1] * q.normal;
      expected += p.weight * q.weight * moment_densities(order, spheres.radii[0], p.normal).transpose() *
                  blake_tensor(x, y) * moment_densities(order, spheres.radii[1], q.normal);
    }
  }
  EXPECT_LT((found.block(0, count, count, count) - expected).norm(), 1e-7 * expected.norm());
  for (int m = 0; m < count; ++m)
    EXPECT_LT((found.block(0, count + m, count, 1) - expected.col(m)).norm(), 1e-6 * expected.col(m).norm())
        << m;
}

TEST_P(HalfSpaceOrder, AnyAxisIsEqualExceptForItsName) {
  const int order = GetParam();
  const Spheres over_z{.radii = {0.7, 0.4}, .places = {{0.1, 0.2, 0.9}, {1.0, -0.6, 0.55}}};
  Spheres over_x = over_z;
  for (Vec3& place : over_x.places) place = Vec3(place[2], place[0], place[1]);
  const Eigen::MatrixXd found = mobility(over_wall(MobilityModel::multipole, over_x, order, 0), over_x);
  const Eigen::MatrixXd expected = mobility(over_wall(MobilityModel::multipole, over_z, order), over_z);
  for (int k = 0; k < 6; ++k)
    for (int m = 0; m < 6; ++m)
      EXPECT_NEAR(found(3 * (k / 3) + (k % 3 + 1) % 3, 3 * (m / 3) + (m % 3 + 1) % 3), expected(k, m), 1e-11);
}

/// Returns spheres of random radii, some of which touch the wall.
Spheres random_spheres(std::mt19937& random, int count) {
  std::uniform_real_distribution<double> unit(0, 1);
  Spheres spheres;
  for (int b = 0; b < count; ++b) {
    const double radius = std::pow(10.0, -1.5 * unit(random));
    const double gap = unit(random) < 0.3 ? 0 : std::pow(10.0, 2 - 5 * unit(random));
    spheres.radii.push_back(radius);
    spheres.places.emplace_back(3 * unit(random), 3 * unit(random), radius + gap);
  }
  return spheres;
}

// Spheres may overlap one another and touch the wall.
TEST(HalfSpace, MobilityOfPairsIsSymmetricAndPositiveDefinite) {
  std::mt19937 random(20261127);
  for (int n = 0; n < 10000; ++n) {
    const Spheres spheres = random_spheres(random, 2);
    Eigen::MatrixXd m = mobility(over_wall(MobilityModel::rpy, spheres), spheres);
    ASSERT_LT((m - m.transpose()).norm(), 1e-13 * m.norm()) << n;
    const Eigen::VectorXd eigenvalues = Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(m).eigenvalues();
    ASSERT_GT(eigenvalues.minCoeff(), 1e-3 * m.diagonal().minCoeff()) << n;
  }
}

TEST_P(HalfSpaceOrder, MatrixOfMomentsIsSymmetricAndPositiveDefinite) {
  const int order = GetParam(), count = moment_count(order);
  std::mt19937 random(20261128);
  for (int n = 0; n < 200; ++n) {
    const Spheres spheres = random_spheres(random, 3);
    Eigen::MatrixXd m = moment_matrix(order, spheres);
    for (Eigen::Index b = 0; b < m.rows(); ++b) {  // all moments in units of a force
      if (degree_of_moment(static_cast<int>(b % count)) != 1) continue;
      m.row(b) *= spheres.radii[b / count];
      m.col(b) *= spheres.radii[b / count];
    }
    ASSERT_LT((m - m.transpose()).norm(), 1e-12 * m.norm()) << n;
    const Eigen::VectorXd eigenvalues =
        Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(m + m.transpose()).eigenvalues();
    ASSERT_GT(eigenvalues.minCoeff(), 0) << n;
  }
}

TEST_P(HalfSpaceOrder, FluidIsAtRestOnTheWall) {
  const int order = GetParam();
  std::mt19937 random(20261129);
  for (int n = 0; n < 20; ++n) {
    Spheres spheres = random_spheres(random, 3);
    spheres.radii.push_back(1e-15);  // a tracer on the wall, without force
    spheres.places.emplace_back(1.5, 1.2, 1e-15);
    const std::vector<Vec3> forces{{1, -0.4, 2}, {0.3, 1, -1}, {-2, 0.1, 0.7}, Vec3::Zero()};
    const std::vector<Vec3> v =
        velocities(over_wall(MobilityModel::multipole, spheres, order), spheres, forces);
    double largest = 0;
    for (int b = 0; b < 3; ++b) largest = std::max(largest, v[b].norm());
    EXPECT_LT(v[3].norm(), 1e-12 * largest);
  }
}

// Brenner (1961); Cox & Brenner, Chem. Eng. Sci. 22 (1967) 1753, for thin films.
TEST(HalfSpace, DragTowardsTheWallIsExact) {
  EXPECT_NEAR(1 / drag_towards_wall(2), 0.47047, 5e-6);
  EXPECT_NEAR(1 / drag_towards_wall(3), 0.63727, 5e-6);
  EXPECT_NEAR(1 / drag_towards_wall(5), 0.77816, 5e-6);
  for (const double gap : {1e-2, 1e-3, 1e-4})
    EXPECT_NEAR(drag_towards_wall(1 + gap), 1 / gap + std::log(1 / gap) / 5 + 0.9713,
                gap * std::log(1 / gap) + 2e-4);
}

TEST(HalfSpace, ASphereApproachesTheWallAsByBrennersExactSolution) {
  const double stokes = 1 / (6 * pi * viscosity);
  for (int order = 0; order <= 2; ++order) {
    const int power = 4 + 2 * order;
    const double leading =
        std::array{0.63, 0.30, 0.12}[order];  // of the error times H^power, measured far away
    for (const double H : {1.5, 2.0, 3.0, 5.0, 8.0}) {
      const Spheres sphere{.radii = {1}, .places = {Vec3(0, 0, H)}};
      const double found =
          mobility(over_wall(MobilityModel::multipole, sphere, order), sphere)(2, 2) / stokes;
      const double error = (found * drag_towards_wall(H) - 1) * std::pow(H, power);
      EXPECT_GT(error, leading * 0.9) << H << order;
      EXPECT_LT(error, leading * (1 + 4.5 / (H * H))) << H << order;
    }
  }
}

TEST(HalfSpace, NearFieldsMakeTheApproachExact) {
  const double a = 0.8, stokes = 1 / (6 * pi * viscosity * a);
  for (const int axis : {0, 2}) {
    for (const double H : {1.0002, 1.01, 1.1, 1.5, 3.0, 4.7, 20.0, 100.0}) {
      Spheres sphere{.radii = {a}, .places = {Vec3(0.3, -2, 1)}};
      sphere.places[0][axis] = H * a;
      Eigen::MatrixXd found = mobility(over_wall(MobilityModel::rpy_near, sphere, 0, axis), sphere);
      EXPECT_NEAR(found(axis, axis) / stokes * drag_towards_wall(H), 1, 1e-7) << axis << H;
      if (H > 4 && H < 6) continue;  // where the stresslet fades
      const bool has_stresslet = H < 5;
      const MobilityModel model = has_stresslet ? MobilityModel::multipole : MobilityModel::rpy;
      const Eigen::MatrixXd along = mobility(over_wall(model, sphere, 1, axis), sphere);
      found(axis, axis) = along(axis, axis);
      EXPECT_LT((found - along).norm(), (has_stresslet ? 1e-12 : 1e-15) * stokes) << axis << H;
    }
  }
}

// The mobility of one sphere with moments of order 2 is 6.5 and 0.7 % too large at these heights.
TEST(HalfSpace, NearFieldsMakeTheApproachOfPairsMoreExact) {
  for (const double H : {1.3, 1.6}) {
    const Spheres spheres{.radii = {1, 1}, .places = {{0, 0, H}, {2.5, 0, H}}};
    for (const double other : {1.0, 0.0, -1.0}) {
      const auto approach = [&](MobilityModel model, int order) {
        return velocities(over_wall(model, spheres, order), spheres,
                          {Vec3(0, 0, 1), Vec3(0, 0, other)})[0][2];
      };
      const double expected = approach(MobilityModel::multipole, 2);
      EXPECT_NEAR(approach(MobilityModel::rpy_near, 0) / expected, 1, 0.08) << H << other;
      EXPECT_GT(approach(MobilityModel::rpy, 0) / expected, 1.1) << H << other;
    }
  }
}

TEST(HalfSpace, NearFieldsKeepTheMobilitySymmetricAndPositiveDefinite) {
  std::mt19937 random(20261201);
  for (int n = 0; n < 20; ++n) {
    const Spheres spheres = random_spheres(random, 3);
    const Eigen::MatrixXd m = mobility(over_wall(MobilityModel::rpy_near, spheres), spheres);
    ASSERT_LT((m - m.transpose()).norm(), 1e-12 * m.norm()) << n;
    ASSERT_GT(Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(m).eigenvalues().minCoeff(), 0) << n;
  }
}

/// Returns spheres of random radii in a slab over the wall, the lowest at the height of their radius.
Spheres slab_of_spheres(int count, double smallest_radius = 0.4) {
  std::mt19937 random(20261130);
  std::uniform_real_distribution<double> unit(0, 1);
  const double edge = 1.8 * std::sqrt(count);
  Spheres spheres;
  for (int b = 0; b < count; ++b) {
    spheres.radii.push_back(smallest_radius + (1 - smallest_radius) * unit(random));
    const double height = spheres.radii.back() + (b % 4 == 0 ? 0 : 9 * unit(random));
    spheres.places.emplace_back(edge * unit(random), edge * unit(random), height);
  }
  return spheres;
}

struct FastSum {
  MobilityModel model;
  int order;
  double tolerance;
  double smallest_radius = 0.4;  ///< the largest radius is 1
};

class FastSumOverWall : public testing::TestWithParam<FastSum> {};
INSTANTIATE_TEST_SUITE_P(
    Models, FastSumOverWall,
    testing::Values(FastSum{MobilityModel::oseen, 0, 1e-4}, FastSum{MobilityModel::rpy, 0, 1e-3},
                    FastSum{MobilityModel::rpy, 0, 1e-6}, FastSum{MobilityModel::rpy, 0, 1e-6, 1},
                    FastSum{MobilityModel::multipole, 1, 1e-4}, FastSum{MobilityModel::multipole, 2, 1e-4}));

/// Returns the moments of all spheres as forces of random directions, and weaker higher moments.
std::vector<double> random_moments(int order, const Spheres& spheres) {
  std::mt19937 random(7);
  std::normal_distribution<double> normal;
  std::vector<double> moments;
  for (const double radius : spheres.radii)
    for (int m = 0; m < moment_count(order); ++m)
      moments.push_back(normal(random) * (m < 3 ? 1 : 0.3) * (degree_of_moment(m) == 1 ? radius : 1));
  return moments;
}

/// Returns M moments with the scene's mesh or, for few spheres, sums over all pairs.
std::vector<double> projections(MobilityScene scene, const Spheres& spheres,
                                const std::vector<double>& moments) {
  const Communicator world(MPI_COMM_WORLD);
  scene.radii = spheres.radii;
  std::vector<double> result(moments.size());
  Mobility(scene, spheres.places, world).project_flow_of(moments, result);
  return result;
}

// The direct sums are over groups of spheres, too few for a mesh, and one sphere at which the flow is found.
TEST_P(FastSumOverWall, EqualsTheSumOverAllPairs) {
  const auto [model, order, tolerance, smallest_radius] = GetParam();
  const int count = moment_count(order), spheres_in_group = 499;
  const Spheres all = slab_of_spheres(1000, smallest_radius);
  const std::vector<double> moments = random_moments(order, all);
  MobilityScene scene = over_wall(model, all, order);
  scene.tolerance = tolerance;
  scene.radii = all.radii;
  EXPECT_TRUE(Mobility(scene, all.places, Communicator(MPI_COMM_WORLD)).plan()->has_mirror_points);
  const std::vector<double> found = projections(scene, all, moments);
  scene.tolerance = 1e-12;
  double error = 0, size = 0;
  for (int target = 0; target < (order == 2 ? 8 : 20); target += 4) {
    std::vector<double> expected(count, 0.0);
    bool has_self = true;  // the flow at the target by itself is counted in the first group
    for (std::size_t first = 0; first < all.radii.size(); first += spheres_in_group) {
      Spheres group{.radii = {all.radii[target]}, .places = {all.places[target]}};
      std::vector<double> sources(count, 0.0);
      if (std::exchange(has_self, false)) std::copy_n(&moments[count * target], count, sources.begin());
      for (std::size_t b = first; b < std::min(first + spheres_in_group, all.radii.size()); ++b) {
        if (static_cast<int>(b) == target) continue;
        group.radii.push_back(all.radii[b]);
        group.places.push_back(all.places[b]);
        sources.insert(sources.end(), &moments[count * b], &moments[count * b] + count);
      }
      const std::vector<double> part = projections(scene, group, sources);
      for (int m = 0; m < count; ++m) expected[m] += part[m];
    }
    for (int m = 0; m < count; ++m) {  // rates of strain as velocities at the surface
      const double scale = degree_of_moment(m) == 1 ? all.radii[target] : 1;
      error += std::pow(scale * (found[count * target + m] - expected[m]), 2);
      size += m < 3 ? std::pow(expected[m], 2) : 0;
    }
  }
  EXPECT_LT(std::sqrt(error / size), tolerance);
}

// Far from the wall a mesh with the mirror points would be mostly empty, and is not used.
TEST(HalfSpace, ManySpheresHighAboveTheWallNeedNoLargeMesh) {
  const int count = 1000;
  Spheres spheres = slab_of_spheres(count);
  const double height = 1e6;
  for (Vec3& place : spheres.places) place.z() += height;
  MobilityScene scene = over_wall(MobilityModel::rpy, spheres);
  scene.tolerance = 1e-4;
  scene.radii = spheres.radii;
  const Mobility product(scene, spheres.places, Communicator(MPI_COMM_WORLD));
  EXPECT_FALSE(product.plan()->has_mirror_points);
  const std::vector<double> moments = random_moments(0, spheres);
  const std::vector<double> found = projections(scene, spheres, moments);
  scene.domain.half_space.reset();
  const std::vector<double> open = projections(scene, spheres, moments);
  const double stokes = 1 / (6 * pi * viscosity);
  for (int k = 0; k < 3 * count; ++k) ASSERT_NEAR(found[k], open[k], 1e-3 * stokes);
}

/// Velocity of a free sphere in shear flow along a wall, divided by the velocity of this flow at its centre,
/// by height over radius. Goldman, Cox & Brenner, Chem. Eng. Sci. 22 (1967) 653.
constexpr std::pair<double, double> goldman_velocities[]{
    {3.7622, 0.99436}, {2.3524, 0.97768}, {1.5431, 0.92185}};

TEST(HalfSpace, AFreeSphereLagsBehindShearFlowAsInTheExactSolution) {
  for (const auto& [H, expected] : goldman_velocities) {
    double last = 1 - expected;  // of order 0, which moves with the flow
    for (int order = 0; order <= 2; ++order) {
      const Spheres sphere{.radii = {0.5}, .places = {Vec3(7, -2, 0.5 * H)}};
      MobilityScene scene = over_wall(MobilityModel::multipole, sphere, order);
      scene.flow.velocity_gradient(0, 2) = 3;
      const Vec3 v = velocities(scene, sphere, {Vec3::Zero()})[0];
      const double error = std::abs(v[0] / (3 * 0.5 * H) - expected);
      EXPECT_LT(error, (order == 0 ? 1 : 0.25) * last + 5e-6) << H << order;  // the table has five digits
      EXPECT_NEAR(v[1], 0, 1e-14);
      EXPECT_NEAR(v[2], 0, 1e-14);
      last = error;
    }
  }
}

// Batchelor & Green, J. Fluid Mech. 56 (1972) 375: two equal spheres at r = r n in the rate of strain E have
// the relative velocity r E n - r [A nn + B (I - nn)] E n.
TEST(BackgroundFlow, FreePairsMoveAsByBatchelorAndGreen) {
  const double r = 6;  // radii
  const double A = 5 / std::pow(r, 3) - 8 / std::pow(r, 5) + 25 / std::pow(r, 6);
  const double B = 16.0 / 3 / std::pow(r, 5);
  const Vec3 n = Vec3(2, -1, 2).normalized();
  Eigen::Matrix3d gradient;
  gradient << 0.3, 1, -0.2, 0.4, -0.8, 0.1, 2, 0.3, 0.5;
  const Eigen::Matrix3d strain = (gradient + gradient.transpose()) / 2;
  const Spheres spheres{.radii = {2, 2}, .places = {{1, 2, 3}, Vec3(Vec3(1, 2, 3) + 2 * r * n)}};
  for (int order = 0; order <= 2; ++order) {
    const MobilityScene scene{.model = MobilityModel::multipole,
                              .viscosity = viscosity,
                              .domain = {},
                              .radii = spheres.radii,
                              .tolerance = 1e-12,
                              .moment_order = order,
                              .flow = {.velocity = {5, 6, 7}, .velocity_gradient = gradient}};
    const std::vector<Vec3> v = velocities(scene, spheres, std::vector<Vec3>(2, Vec3::Zero()));
    const Vec3 relative = (v[1] - v[0]) / (2 * r) - gradient * n;
    const Vec3 along = n * n.dot(strain * n);
    const Vec3 expected = -A * along - B * (strain * n - along);
    EXPECT_LT((v[0] + v[1] - scene.flow.at(spheres.places[0]) - scene.flow.at(spheres.places[1])).norm(),
              1e-12);
    const double limit = std::array{1 + 1e-12, 0.03, 0.01}[order];  // order 0 moves with the flow
    EXPECT_LT((relative - expected).norm(), limit * expected.norm());
  }
}

TEST(BackgroundFlow, ABoxIsRefused) {
  const Communicator self(MPI_COMM_SELF);
  const Spheres sphere{.radii = {1}, .places = {{4, 4, 4}}};
  MobilityScene scene = over_wall(MobilityModel::rpy, sphere);
  scene.domain.box = Box{.lengths = Vec3(9, 9, 9)};
  EXPECT_THROW(Mobility(scene, sphere.places, self), InputError);
  scene.domain.half_space.reset();
  EXPECT_NO_THROW(Mobility(scene, sphere.places, self));
  scene.flow.velocity[1] = 1;
  EXPECT_THROW(Mobility(scene, sphere.places, self), InputError);
}

}  // namespace
}  // namespace beadswim
