#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <numbers>
#include <random>
#include <utility>

#include "beadswim/collinear/multipole_mobility.hpp"
#include "beadswim/core/error.hpp"
#include "beadswim/core/gauss_legendre.hpp"
#include "beadswim/mobility/mobility.hpp"
#include "direct_ewald.hpp"
#include "sphere_surfaces.hpp"

// Mobility products with force moments, against integrals over the surfaces of spheres, exact flows and
// limits.

namespace beadswim {
namespace {

constexpr double pi = std::numbers::pi, viscosity = 0.7;

struct SpherePair {
  std::array<double, 2> radii;
  Vec3 apart;  ///< from the second to the first
};

/// Returns the matrix from moments of the second sphere to projections on the first, by integrals over both
/// surfaces.
Eigen::MatrixXd surface_matrix(int order, const SpherePair& pair, int heights) {
  const std::vector<SurfaceNode> nodes = sphere_nodes(heights);
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(moment_count(order), moment_count(order));
  for (const SurfaceNode& p : nodes) {
    for (const SurfaceNode& q : nodes) {
      const Eigen::Vector3d r = pair.apart + pair.radii[0] * p.normal - pair.radii[1] * q.normal;
      const double d = r.norm();
      const Eigen::Matrix3d oseen =
          (Eigen::Matrix3d::Identity() + r * r.transpose() / (d * d)) / (8 * pi * viscosity * d);
      matrix += p.weight * q.weight * moment_densities(order, pair.radii[0], p.normal).transpose() * oseen *
                moment_densities(order, pair.radii[1], q.normal);
    }
  }
  return matrix;
}

MobilityScene scene_of(int order, const std::vector<double>& radii, double tolerance) {
  return {.model = MobilityModel::multipole,
          .viscosity = viscosity,
          .domain = {},
          .radii = radii,
          .tolerance = tolerance,
          .moment_order = order};
}

/// Returns the matrix from the moments of sphere `from` of a pair to the projections on sphere `to`.
Eigen::MatrixXd open_matrix(int order, const SpherePair& pair, int from, int to) {
  const Communicator self(MPI_COMM_SELF);
  const int count = moment_count(order);
  Mobility mobility(scene_of(order, {pair.radii[0], pair.radii[1]}, 1e-4),
                    std::vector<Vec3>{pair.apart, Vec3::Zero()}, self);
  Eigen::MatrixXd matrix(count, count);
  for (int m = 0; m < count; ++m) {
    const Eigen::VectorXd moments = Eigen::VectorXd::Unit(2 * count, count * from + m);
    Eigen::VectorXd projections(2 * count);
    mobility.project_flow_of({moments.data(), moments.data() + 2 * count},
                             {projections.data(), projections.data() + 2 * count});
    matrix.col(m) = projections.segment(count * to, count);
  }
  return matrix;
}

class MomentOrder : public testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(Orders, MomentOrder, testing::Values(1, 2));

// Catches a wrong derivative, sign, basis or factor c_l.
TEST_P(MomentOrder, FlowOfAPairIsTheIntegralOverBothSurfaces) {
  const int order = GetParam();
  for (const SpherePair& pair :
       {SpherePair{{1, 1}, {2.5, 0.4, -1.1}}, SpherePair{{1.3, 0.6}, {-1.2, 2, 1.7}}}) {
    const Eigen::MatrixXd expected = surface_matrix(order, pair, 16), found = open_matrix(order, pair, 1, 0);
    EXPECT_LT((found - expected).norm(), 1e-9 * expected.norm());
    for (int m = 0; m < moment_count(order); ++m)
      EXPECT_LT((found.col(m) - expected.col(m)).norm(), 1e-8 * expected.col(m).norm()) << m;
    EXPECT_LT((open_matrix(order, pair, 0, 1) - found.transpose()).norm(), 1e-14 * found.norm());
  }
}

// The pair becomes the sphere itself as two equal spheres come together.
TEST_P(MomentOrder, FlowOfSpheresThatCoincideIsTheirOwn) {
  const int order = GetParam();
  const Eigen::MatrixXd own = moment_self_mobility(order, 1.3, viscosity);
  for (const double r : {0.0, 1e-5, 1e-3})  // closer than 1e-6 radii, the flow is that at this distance
    EXPECT_LT((open_matrix(order, {{1.3, 1.3}, r * Vec3(0.6, 0, -0.8)}, 1, 0) - own).norm(),
              2 * (r + 1e-6) * own.norm())
        << r;
}

// Catches a wrong polynomial of overlapping spheres: the flow has no jump where they touch, and one holds the
// other.
TEST_P(MomentOrder, FlowOfOverlappingSpheresIsContinuous) {
  const int order = GetParam();
  for (const auto& [radii, edge] :
       {std::pair{std::array{1.3, 0.6}, 1.9}, std::pair{std::array{1.3, 0.6}, 0.7},
        std::pair{std::array{1.0, 1.01}, 0.01}}) {
    const Vec3 along = Vec3(2, -1, 2) / 3;
    const Eigen::MatrixXd before = open_matrix(order, {radii, (edge - 1e-7) * along}, 1, 0),
                          after = open_matrix(order, {radii, (edge + 1e-7) * along}, 1, 0);
    EXPECT_LT((before - after).norm(), 1e-5 * before.norm()) << edge;
  }
}

/// Returns the projections, on each sphere in a box, of the flow of all moments, by a direct sum over images
/// and wavevectors of points on the surfaces. A sphere's own flow in open space, which points do not resolve,
/// is replaced by the known one.
std::vector<double> direct_projections(int order, const std::vector<double>& radii,
                                       const direct::Vectors& centres, const Box& box,
                                       const std::vector<double>& moments) {
  const std::vector<SurfaceNode> nodes = sphere_nodes(6);
  const int count = moment_count(order);
  const auto points_of = [&](std::size_t sphere) {
    direct::Spheres points;
    for (const SurfaceNode& node : nodes) {
      points.places.push_back(centres[sphere] + radii[sphere] * node.normal);
      points.radii.push_back(1);
      points.forces.push_back(node.weight * moment_densities(order, radii[sphere], node.normal) *
                              Eigen::Map<const Eigen::VectorXd>(&moments[count * sphere], count));
    }
    return points;
  };
  direct::Spheres all = points_of(0);
  const direct::Spheres second = points_of(1);
  all.places.insert(all.places.end(), second.places.begin(), second.places.end());
  all.radii.insert(all.radii.end(), second.radii.begin(), second.radii.end());
  all.forces.insert(all.forces.end(), second.forces.begin(), second.forces.end());
  const direct::Vectors flow = direct::box_velocities(direct::Law::oseen, all, viscosity, box);
  std::vector<double> projections(2 * count);
  for (std::size_t sphere = 0; sphere < 2; ++sphere) {
    const direct::Vectors own = direct::open_velocities(direct::Law::oseen, points_of(sphere), viscosity);
    Eigen::VectorXd sum = moment_self_mobility(order, radii[sphere], viscosity) *
                          Eigen::Map<const Eigen::VectorXd>(&moments[count * sphere], count);
    for (std::size_t k = 0; k < nodes.size(); ++k)
      sum += nodes[k].weight * moment_densities(order, radii[sphere], nodes[k].normal).transpose() *
             (flow[nodes.size() * sphere + k] - own[k]);
    std::ranges::copy(sum, projections.begin() + count * sphere);
  }
  return projections;
}

// Catches a wrong window derivative, mirror image or far flow at a sphere itself.
TEST_P(MomentOrder, FlowInABoxIsTheDirectSum) {
  const int order = GetParam(), count = moment_count(order);
  const Communicator world(MPI_COMM_WORLD);
  const std::vector<double> radii{1.2, 0.7};
  const direct::Vectors centres{{3, 2.5, 4}, {6.2, 4.5, 2.2}};
  const std::vector<Vec3> places(centres.begin(), centres.end());
  std::mt19937 random(3);
  std::uniform_real_distribution<double> uniform(-1, 1);
  std::vector<double> moments(2 * count), found(2 * count);
  for (double& moment : moments) moment = uniform(random);
  for (const Box& box : {Box{{9, 8, 10}, {}},
                         Box{{9, 8, 10}, {Boundary::periodic, Boundary::free_slip, Boundary::periodic}}}) {
    const std::vector<double> expected = direct_projections(order, radii, centres, box, moments);
    for (const double tolerance : {1e-3, 1e-5, 1e-6}) {
      const MobilityScene scene{.model = MobilityModel::multipole,
                                .viscosity = viscosity,
                                .domain = {.box = box},
                                .radii = radii,
                                .tolerance = tolerance,
                                .moment_order = order};
      Mobility(scene, places, world).project_flow_of(moments, found);
      double difference = 0, size = 0;
      for (int k = 0; k < 2 * count; ++k)
        difference += std::pow(found[k] - expected[k], 2), size += expected[k] * expected[k];
      EXPECT_LT(std::sqrt(difference / size), tolerance);
    }
  }
}

/// Returns the velocities of spheres by a product.
direct::Vectors velocities(const MobilityScene& scene, const direct::Vectors& places,
                           const direct::Vectors& forces) {
  const Communicator world(MPI_COMM_WORLD);
  const std::vector<Vec3> x(places.begin(), places.end()), f(forces.begin(), forces.end());
  std::vector<Vec3> v(x.size());
  Mobility(scene, x, world).apply(f, v);
  return {v.begin(), v.end()};
}

direct::Spheres random_spheres(int count, double edge) {
  std::mt19937 random(static_cast<unsigned>(count));
  std::uniform_real_distribution<double> uniform(0, 1);
  direct::Spheres spheres;
  for (int b = 0; b < count; ++b) {
    spheres.places.push_back(edge * Eigen::Vector3d(uniform(random), uniform(random), uniform(random)));
    spheres.radii.push_back(1 + 0.8 * uniform(random));
    spheres.forces.push_back(Eigen::Vector3d(uniform(random), uniform(random), uniform(random)).array() -
                             0.5);
  }
  return spheres;
}

double relative_difference(const std::vector<double>& a, const std::vector<double>& b) {
  double difference = 0, size = 0;
  for (std::size_t k = 0; k < a.size(); ++k) difference += std::pow(a[k] - b[k], 2), size += b[k] * b[k];
  return std::sqrt(difference / size);
}

// Against sums over all pairs of groups of spheres, too few for a mesh: the flow of half of the spheres and
// of all others but the last, and the flow of the last. Catches a wrong kernel of the mesh, and pairs that
// are lost.
TEST_P(MomentOrder, FlowInOpenSpaceByAMeshIsTheSumOfAllPairs) {
  const int order = GetParam(), count = 1000;
  const Communicator world(MPI_COMM_WORLD);
  const direct::Spheres spheres = random_spheres(count, 25);  // many overlap
  const std::vector<Vec3> places(spheres.places.begin(), spheres.places.end());
  const int size = moment_count(order), half = count / 2;
  std::vector<double> moments(count * size), found(moments.size());
  std::mt19937 random(5);
  std::uniform_real_distribution<double> uniform(-1, 1);
  for (double& moment : moments) moment = uniform(random);
  const auto flow_at_half = [&](std::vector<double> radii, std::vector<Vec3> group,
                                const std::vector<double>& sources) {
    std::vector<double> flow(sources.size());
    Mobility(scene_of(order, radii, 1e-5), group, world).project_flow_of(sources, flow);
    flow.resize(half * size);
    return flow;
  };
  std::vector<double> expected =
      flow_at_half({spheres.radii.begin(), spheres.radii.end() - 1}, {places.begin(), places.end() - 1},
                   {moments.begin(), moments.end() - size});
  std::vector<double> radii(spheres.radii.begin(), spheres.radii.begin() + half), last(half * size, 0.0);
  std::vector<Vec3> with_last(places.begin(), places.begin() + half);
  radii.push_back(spheres.radii.back());
  with_last.push_back(places.back());
  last.insert(last.end(), moments.end() - size, moments.end());
  const std::vector<double> by_last = flow_at_half(radii, with_last, last);
  for (std::size_t k = 0; k < expected.size(); ++k) expected[k] += by_last[k];
  for (const double tolerance : {1e-3, 1e-5, 1e-8}) {
    Mobility meshed(scene_of(order, spheres.radii, tolerance), places, world);
    ASSERT_TRUE(meshed.plan());
    found.resize(moments.size());
    meshed.project_flow_of(moments, found);
    found.resize(half * size);
    EXPECT_LT(relative_difference(found, expected), tolerance);
  }
}

// Spheres anywhere, also within one another, dissipate energy whatever the forces.
TEST_P(MomentOrder, MobilityIsPositiveDefiniteAtAllSeparations) {
  direct::Spheres spheres = random_spheres(9, 4);
  spheres.places[1] = spheres.places[0] + Eigen::Vector3d(0, 0.2, 0.1);
  spheres.radii[1] = spheres.radii[0];
  spheres.places[3] = spheres.places[2];
  const Eigen::MatrixXd mobility = direct::mobility_matrix(spheres, [&](const direct::Spheres& pushed) {
    return velocities(scene_of(GetParam(), pushed.radii, 1e-7), pushed.places, pushed.forces);
  });
  EXPECT_LT((mobility - mobility.transpose()).norm(), 1e-6 * mobility.norm());
  const Eigen::VectorXd eigenvalues =
      Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(mobility + mobility.transpose()).eigenvalues();
  EXPECT_GT(eigenvalues.minCoeff(), 1e-5 * eigenvalues.maxCoeff());
}

// Spheres without forces, a sphere alone and positions that are no numbers need no iterations and crash
// nothing.
TEST_P(MomentOrder, ProductsOfUnusualInputEnd) {
  const Communicator world(MPI_COMM_WORLD);
  for (const bool is_periodic : {false, true}) {
    direct::Spheres spheres = random_spheres(1000, 90);
    MobilityScene scene = scene_of(GetParam(), spheres.radii, 1e-4);
    if (is_periodic) scene.domain.box = Box{{90, 90, 90}, {}};
    Mobility mobility(scene, spheres.places, world);
    direct::Vectors velocities(spheres.places.size()), again = velocities;
    EXPECT_GT(mobility.apply(spheres.forces, velocities).iterations, 1);
    mobility.apply(spheres.forces, again);
    EXPECT_EQ(velocities, again);
    const direct::Vectors nothing(spheres.places.size(), Eigen::Vector3d::Zero());
    const ProductWork idle = mobility.apply(nothing, velocities);
    EXPECT_EQ(velocities, nothing);
    EXPECT_EQ(idle.iterations, 0);
    EXPECT_EQ(idle.residual, 0);
    spheres.places[7] = Vec3::Constant(std::nan(""));
    try {
      mobility.set_positions(spheres.places);
      mobility.apply(spheres.forces, velocities);
      EXPECT_FALSE(velocities[7].allFinite());
    } catch (const SolverError&) {  // no mesh spans it
      EXPECT_FALSE(is_periodic);
    }
  }
  const std::vector<Vec3> origin{Vec3::Zero()}, force{Vec3(0, 2, 0)};
  std::vector<Vec3> velocity(1);
  Mobility lone(scene_of(GetParam(), {1.5}, 1e-4), origin, world);
  EXPECT_EQ(lone.apply(force, velocity).iterations, 0);
  EXPECT_DOUBLE_EQ(velocity[0].y(), 2 / (6 * pi * viscosity * 1.5));
}

TEST(MultipoleProduct, RefusesOrdersThatItDoesNotKnow) {
  const Communicator world(MPI_COMM_WORLD);
  const std::vector<Vec3> origin{Vec3::Zero()};
  for (const int order : {-1, 3})
    EXPECT_THROW(Mobility(scene_of(order, {1}, 1e-4), origin, world), InputError);
}

TEST(MultipoleProduct, OfOrderZeroIsRotnePragerBitForBit) {
  for (const int count : {12, 1200}) {
    const direct::Spheres spheres = random_spheres(count, 30);
    MobilityScene scene = scene_of(0, spheres.radii, 1e-4);
    const direct::Vectors multipole = velocities(scene, spheres.places, spheres.forces);
    scene.model = MobilityModel::rpy;
    EXPECT_EQ(multipole, velocities(scene, spheres.places, spheres.forces));
  }
}

// Each order comes nearer to the exact flow of two spheres: its error falls with two more powers of a/r.
TEST(MultipoleProduct, TendsToTheExactFlowOfTwoSpheres) {
  for (const std::vector<double>& radii : {std::vector{1.0, 1.0}, std::vector{1.0, 1.6}}) {
    for (int order = 0; order <= 2; ++order) {
      std::array<double, 3> errors{};
      for (int k = 0; k < 3; ++k) {
        const double r = std::array{4.0, 6.0, 9.0}[k];
        const MultipoleMobility exact = multipole_mobility(radii, std::array{0.0, r}, viscosity);
        const direct::Vectors v =
            velocities(scene_of(order, radii, 1e-11), {Eigen::Vector3d::Zero(), r * Eigen::Vector3d::UnitX()},
                       {Eigen::Vector3d::UnitX(), Eigen::Vector3d::Zero()});
        errors[k] = std::abs(v[0][0] / exact.value(0, 0) - 1);
      }
      for (int k = 0; k < 2; ++k)
        EXPECT_NEAR(std::log(errors[k] / errors[k + 1]) / std::log(1.5), 4 + 2 * order, 0.35)
            << "order " << order << ", radius " << radii[1];
    }
  }
}

// One of two equal spheres is pulled across their line: 6 pi eta a v/F = 1 - 17/16 (a/r)^6 + O((a/r)^8)
// (Jeffrey & Onishi, J. Fluid Mech. 139 (1984) 261). Second moments give this term, Rotne-Prager theory
// gives 1.
TEST(MultipoleProduct, TendsToTheExactFlowAcrossTheLine) {
  for (const double r : {5.0, 7.0}) {
    const direct::Vectors v =
        velocities(scene_of(2, {1, 1}, 1e-11), {Eigen::Vector3d::Zero(), r * Eigen::Vector3d::UnitX()},
                   {Eigen::Vector3d::UnitY(), Eigen::Vector3d::Zero()});
    const double term = 17.0 / 16 * std::pow(r, -6);
    EXPECT_NEAR(1 - 6 * pi * viscosity * v[0][1], term, 3 * term / (r * r));
  }
}

// Drag of a simple cubic array (Zick & Homsy, J. Fluid Mech. 115 (1982) 13). A cubic array strains none of
// its spheres, so order 1 adds nothing to order 0; order 2 does.
TEST(MultipoleProduct, TendsToTheDragOfACubicArray) {
  for (const auto& [fraction, drag] : {std::pair{0.027, 2.008}, std::pair{0.064, 2.810}}) {
    std::array<double, 3> errors{};
    for (int order = 0; order <= 2; ++order) {
      MobilityScene scene = scene_of(order, {1}, 1e-8);
      const double edge = std::cbrt(4 * pi / 3 / fraction);
      scene.domain.box = Box{{edge, edge, edge}, {}};
      const direct::Vectors v = velocities(scene, {{0.3, 0.1, 0.2}}, {Eigen::Vector3d::UnitX()});
      errors[order] = std::abs(1 / (6 * pi * viscosity * v[0][0]) / drag - 1);
    }
    EXPECT_NEAR(errors[1], errors[0], 1e-6);
    EXPECT_GT(errors[0], 1.5e-3);
    EXPECT_LT(errors[2], 4e-4);
  }
}

// A product whose residual is not a number did not converge.
TEST_P(MomentOrder, ProductsOfInvalidForcesDoNotConverge) {
  const Communicator world(MPI_COMM_WORLD);
  Mobility mobility(scene_of(GetParam(), {1, 1}, 1e-4), std::vector<Vec3>{{0, 0, 0}, {3, 0, 0}}, world);
  std::vector<Vec3> velocities(2);
  EXPECT_TRUE(mobility.apply(std::vector<Vec3>{{1, 0, 0}, {0, 2, 0}}, velocities).is_converged);
  EXPECT_FALSE(mobility.apply(std::vector<Vec3>{{std::nan(""), 0, 0}, {0, 2, 0}}, velocities).is_converged);
}

}  // namespace
}  // namespace beadswim
