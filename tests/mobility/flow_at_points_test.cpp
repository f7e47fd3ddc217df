#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <memory>
#include <numbers>

#include "beadswim/core/error.hpp"
#include "beadswim/core/keyed_random.hpp"
#include "beadswim/mobility/mobility.hpp"
#include "direct_ewald.hpp"

// Flow of spheres at points (Mobility::flow_at). Units: radius of the large spheres, viscosity 1.

namespace beadswim {
namespace {

constexpr double pi = std::numbers::pi, viscosity = 1;

const Communicator& world() {
  static const auto* const communicator = new Communicator(MPI_COMM_WORLD);  // freed by MPI_Finalize
  return *communicator;
}

std::vector<Vec3> random_points(std::uint64_t seed, int count, const Vec3& low, const Vec3& high) {
  KeyedRandom random(seed, 0, 0);
  std::vector<Vec3> points(count);
  for (Vec3& point : points)
    for (int a = 0; a < 3; ++a)
      point[a] = low[a] + (high[a] - low[a]) * 0.5 * (1 + std::tanh(random.normal()));
  return points;
}

/// Spheres on a jittered lattice, with forces of zero sum.
struct Swarm {
  std::vector<Vec3> places, forces;
  std::vector<double> radii;
};

Swarm swarm(int edge, double spacing) {
  Swarm result;
  KeyedRandom random(3, 0, 0);
  Vec3 sum = Vec3::Zero();
  for (int i = 0; i < edge * edge * edge; ++i) {
    Vec3 at(i % edge + 0.5, i / edge % edge + 0.5, i / edge / edge + 0.5), force;
    for (int a = 0; a < 3; ++a) {
      at[a] = spacing * at[a] + 0.2 * random.normal();
      force[a] = random.normal();
    }
    result.places.push_back(at);
    result.forces.push_back(force);
    result.radii.push_back(i % 2 == 0 ? 1 : 0.7);
    sum += force;
  }
  for (Vec3& force : result.forces) force -= sum / static_cast<double>(result.places.size());
  return result;
}

MobilityScene scene_of(MobilityModel model, int order, double tolerance) {
  MobilityScene scene;
  scene.model = model;
  scene.moment_order = order;
  scene.tolerance = tolerance;
  return scene;
}

struct Applied {
  std::unique_ptr<Mobility> mobility;
  std::vector<Vec3> places, velocities;

  FlowAtPoints flow_at(std::span<const Vec3> points) const {
    return mobility->flow_at(points,
                             {.positions = places, .velocities = velocities, .moments = mobility->moments()});
  }
};

Applied applied(MobilityScene scene, const Swarm& spheres) {
  scene.viscosity = viscosity;
  scene.radii = spheres.radii;
  Applied result{std::make_unique<Mobility>(scene, spheres.places, world()), spheres.places, spheres.forces};
  result.mobility->apply(spheres.forces, result.velocities, FlowPart::all);
  return result;
}

double root_mean_square(std::span<const Vec3> vectors) {
  double sum = 0;
  for (const Vec3& v : vectors) sum += v.squaredNorm();
  return std::sqrt(sum / static_cast<double>(vectors.size()));
}

const Swarm pulled{.places = {Vec3(0.3, -0.2, 2)}, .forces = {Vec3(1, 2, -3)}, .radii = {1}};

/// Exact Stokes flow of a sphere of radius 1 at the vector r from its centre.
Vec3 stokes_flow(const Vec3& r, const Vec3& force) {
  const double d = r.norm();
  const Vec3 e = r / d;
  return ((1 + 1 / (3 * d * d)) * force + (1 - 1 / (d * d)) * e.dot(force) * e) / (8 * pi * viscosity * d);
}

TEST(FlowAtPoints, IsTheExactFlowOfAPulledSphere) {
  for (int order = 0; order <= 2; ++order) {
    const Applied sphere = applied(scene_of(MobilityModel::multipole, order, 1e-6), pulled);
    const std::vector<Vec3> points = random_points(1, 50, Vec3(-4, -4, -3), Vec3(4, 4, 7));
    const FlowAtPoints flow = sphere.flow_at(points);
    for (std::size_t p = 0; p < points.size(); ++p) {
      const Vec3 r = points[p] - pulled.places[0];
      const Vec3 exact =
          r.norm() < 1 ? Vec3(pulled.forces[0] / (6 * pi * viscosity)) : stokes_flow(r, pulled.forces[0]);
      EXPECT_LT((flow.velocities[p] - exact).norm(), 1e-13) << order << ": " << points[p].transpose();
      EXPECT_EQ(flow.spheres[p], r.norm() < 1 ? 0 : -1);
    }
  }
}

TEST(FlowAtPoints, IsTheDirectPeriodicSumInBoxes) {
  for (const Boundary boundary : {Boundary::periodic, Boundary::free_slip}) {
    for (const MobilityModel model : {MobilityModel::oseen, MobilityModel::rpy}) {
      const Box box{.lengths = Vec3(13, 12, 14), .boundary = {boundary, Boundary::periodic, boundary}};
      Swarm spheres = swarm(2, 6);
      MobilityScene scene = scene_of(model, 0, 1e-9);
      scene.domain.box = box;
      const Applied in_box = applied(scene, spheres);
      const std::vector<Vec3> points = random_points(2, 12, Vec3::Zero(), box.lengths);
      const FlowAtPoints flow = in_box.flow_at(points);
      // The reference has the points as spheres of a radius near 0, without force.
      direct::Spheres all{.places = points,
                          .radii = std::vector(points.size(), 1e-6),
                          .forces = std::vector<Vec3>(points.size(), Vec3::Zero())};
      const auto append = [](auto& to, const auto& more) { to.insert(to.end(), more.begin(), more.end()); };
      append(all.places, spheres.places);
      append(all.radii, spheres.radii);
      append(all.forces, spheres.forces);
      const direct::Law law = model == MobilityModel::oseen ? direct::Law::oseen : direct::Law::rotne_prager;
      const direct::Vectors exact = direct::box_velocities(law, all, viscosity, box);
      const double scale = root_mean_square(in_box.velocities);
      for (std::size_t p = 0; p < points.size(); ++p)
        if (flow.spheres[p] < 0) {
          EXPECT_LT((flow.velocities[p] - exact[p]).norm(), 1e-8 * scale) << points[p].transpose();
        }
    }
  }
}

/// Largest difference between the flow at many points, for which a mesh is used, and at few of them.
double mesh_error(const MobilityScene& scene, const Swarm& spheres, const Vec3& low, const Vec3& high) {
  const Applied product = applied(scene, spheres);
  const std::vector<Vec3> points = random_points(4, 20000, low, high);
  const FlowAtPoints by_mesh = product.flow_at(points);
  const auto few = std::span(points).first(20);
  const FlowAtPoints direct = product.flow_at(few);
  double worst = 0;
  for (std::size_t p = 0; p < few.size(); ++p)
    worst = std::max(worst, (by_mesh.velocities[p] - direct.velocities[p]).norm());
  EXPECT_GT(worst, 0) << "the mesh was not used";
  return worst / root_mean_square(product.velocities);
}

TEST(FlowAtPoints, OfTheMeshIsTheDirectSum) {
  constexpr double tolerance = 1e-4;
  const Vec3 low(-5, -5, 0.2), high(25, 25, 25);
  for (const MobilityModel model : {MobilityModel::oseen, MobilityModel::rpy, MobilityModel::rpy_near})
    EXPECT_LT(mesh_error(scene_of(model, 0, tolerance), swarm(4, 4), low, high), 3 * tolerance);
  for (int order = 0; order <= 2; ++order) {
    MobilityScene scene = scene_of(MobilityModel::multipole, order, tolerance);
    EXPECT_LT(mesh_error(scene, swarm(4, 4), low, high), 3 * tolerance) << order;
    scene.domain.half_space = HalfSpace{};
    EXPECT_LT(mesh_error(scene, swarm(4, 4), low, high), 3 * tolerance) << order << " over a wall";
  }
}

TEST(FlowAtPoints, VanishesOnTheNoSlipWall) {
  for (int order = 0; order <= 2; ++order) {
    MobilityScene scene = scene_of(MobilityModel::multipole, order, 1e-6);
    scene.domain.half_space = HalfSpace{};
    const Applied over_wall = applied(scene, pulled);
    std::vector<Vec3> points = random_points(5, 30, Vec3(-3, -3, 0), Vec3(3, 3, 0));
    for (const Vec3& velocity : over_wall.flow_at(points).velocities) EXPECT_LT(velocity.norm(), 1e-12);
    for (Vec3& point : points) point[2] = 0.3;
    EXPECT_GT(over_wall.flow_at(points).velocities[0].norm(), 1e-3);
  }
}

// A wrong sign of the stresslets, or points of finite size, would change the average.
TEST(FlowAtPoints, AverageOverASurfaceIsTheVelocityOfTheSphere) {
  const Swarm two{.places = {Vec3(0, 0, 2), Vec3(3, 0.5, 1.5)},
                  .forces = {Vec3(1, 2, 0), Vec3(0, -1, 1)},
                  .radii = {1, 0.6}};
  for (int order = 0; order <= 2; ++order) {
    for (const bool has_wall : {false, true}) {
      MobilityScene scene = scene_of(MobilityModel::multipole, order, 1e-10);
      if (has_wall) scene.domain.half_space = HalfSpace{};
      if (!has_wall) scene.flow.velocity_gradient(0, 2) = 0.3;
      const Applied product = applied(scene, two);
      std::vector<Vec3> points;
      constexpr int count = 4000;  // Fibonacci lattice
      for (int k = 0; k < count; ++k) {
        const double z = (2 * k + 1.0) / count - 1, rho = std::sqrt(1 - z * z),
                     phi = k * pi * (3 - std::sqrt(5.0));
        points.push_back(two.places[0] + 1.0000001 * Vec3(rho * std::cos(phi), rho * std::sin(phi), z));
      }
      Vec3 mean = Vec3::Zero();
      for (const Vec3& velocity : product.flow_at(points).velocities) mean += velocity / count;
      EXPECT_LT((mean - product.velocities[0]).norm(), 1e-4 * product.velocities[0].norm()) << order;
    }
  }
}

TEST(FlowAtPoints, RequiresTheMomentsOfAllSpheres) {
  MobilityScene scene = scene_of(MobilityModel::rpy, 0, 1e-6);
  scene.viscosity = viscosity;
  scene.radii = {1};
  const std::vector<Vec3> centre{Vec3::Zero()};
  Mobility mobility(scene, centre, world());
  EXPECT_THROW(mobility.flow_at(std::vector<Vec3>{Vec3(2, 0, 0)},
                                {.positions = centre, .velocities = centre, .moments = mobility.moments()}),
               InputError);
}

}  // namespace
}  // namespace beadswim
