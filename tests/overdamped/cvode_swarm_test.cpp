#include "cvode_swarm.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "scenes.hpp"

namespace beadswim {
namespace {

/// Local error of one step of CVODE, and the accumulated error of some hundreds of steps [length].
constexpr double local = 1e-8, global = 100 * local;

std::vector<Vec3> cvode_after(const OverdampedScene& scene, double end, CvodeJacobian jacobian) {
  return by_cvode(scene, end, {.absolute = local, .jacobian = jacobian}).positions;
}

std::vector<Vec3> cvode_after(const OverdampedScene& scene, double end) {
  return cvode_after(scene, end, CvodeJacobian::difference_quotient);
}

/// Returns the positions after `steps` steps of the library's integrator. Requires that no beads come into
/// contact.
std::vector<Vec3> steps_after(OverdampedScene scene, double end, int steps) {
  scene.step = end / steps;
  const Communicator world(MPI_COMM_WORLD);
  OverdampedSystem system(scene, world);
  for (int n = 0; n < steps; ++n) system.step();
  EXPECT_FALSE(system.fault());
  EXPECT_TRUE(std::isinf(system.state().smallest_gap));
  return {system.positions().begin(), system.positions().end()};
}

/// Checks that the error is of third order: halved steps must have about 1/8 of the error (at most 1/6,
/// because errors of higher order also contribute).
void expect_third_order(const OverdampedScene& scene, double end, int steps, double truncation) {
  const auto start = steps_after(scene, end, 0), exact = cvode_after(scene, end);
  const double coarse = farthest(steps_after(scene, end, steps / 2), exact);
  const double fine = farthest(steps_after(scene, end, steps), exact);
  EXPECT_GT(farthest(start, exact), 1e4 * truncation);
  EXPECT_LT(fine, truncation);
  EXPECT_LT(fine, coarse / 6 + global);
}

// Another integrator, of any order, that chooses its steps. Swimmers turn, bend and drag each other.
TEST(CvodeSwarm, OverdampedSystemMovesAlikeInOpenSpace) {
  const OverdampedScene scene = turned_swimmers();
  constexpr double truncation = 5e-5;  // 2560 steps a cycle: bending relaxes over 6
  expect_third_order(scene, scene.types[0].driving.period / 2, 1280, truncation);
}

TEST(CvodeSwarm, OverdampedSystemMovesAlikeInABoxWithWalls) {
  OverdampedScene scene = turned_swimmers();
  scene.types.push_back(swimmer_type(odd_swimmer()));
  for (Bond& bond : scene.types[1].bonds) bond.damping = 0;
  scene.swimmers[1].type = 1;
  scene.domain.box = Box{{110, 90, 80}, {Boundary::periodic, Boundary::free_slip, Boundary::periodic}};
  scene.tolerance = 1e-6;
  constexpr double truncation = 5e-5;
  expect_third_order(scene, scene.types[0].driving.period / 16, 160, truncation);
}

// Swimmers that all answer to each other's springs more than to their own: surfaces of neighbours are 2/3 of
// a radius apart. 3200 steps a cycle.
TEST(CvodeSwarm, OverdampedSystemMovesAlikeInADenseSwarm) {
  OverdampedScene scene = lattice_of({4, 4}, 16, 1);
  disturb(scene);
  constexpr double truncation = 2e-5;
  const double end = scene.types[0].driving.period / 16;
  const auto start = steps_after(scene, end, 0), exact = cvode_after(scene, end);
  EXPECT_GT(farthest(start, exact), 1e4 * truncation);
  EXPECT_LT(farthest(steps_after(scene, end, 200), exact), truncation);
}

// Held mobility in products of the Jacobian costs iterations, not exactness.
TEST(CvodeSwarm, FindsTheSameByEitherJacobian) {
  const OverdampedScene scene = turned_swimmers();
  const double end = scene.types[0].driving.period / 2;
  EXPECT_LT(farthest(cvode_after(scene, end, CvodeJacobian::springs), cvode_after(scene, end)), global);
}

// The preconditioner takes off what is stiff: explicit steps would be ten times as many.
TEST(CvodeSwarm, TakesFewProductsHoweverStiffTheSpring) {
  OverdampedScene scene = turned_swimmers();
  const double end = scene.types[0].driving.period / 2;
  const CvodeSettings settings{.absolute = 1e-4};
  const long products = by_cvode(scene, end, settings).products;
  EXPECT_LT(products, 200);
  scene.types[0].angles[0].stiffness *= 10;
  EXPECT_LT(by_cvode(scene, end, settings).products, 1.5 * products);
}

}  // namespace
}  // namespace beadswim
