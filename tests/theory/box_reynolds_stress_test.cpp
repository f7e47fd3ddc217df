#include "beadswim/theory/reynolds_stress.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "beadswim/collinear/rotne_prager.hpp"
#include "beadswim/core/complex.hpp"
#include "beadswim/theory/linear_response.hpp"
#include "scenes.hpp"

namespace beadswim {
namespace {

/// Induced forces of no particular phases, with sum zero.
const Eigen::Vector3cd some_force(Complex(0.1, -0.08), Complex(-0.14, -0.08), Complex(0.04, 0.16));

Eigen::Vector3d in_box(const CollinearSwimmer& swimmer, const Box& box, const std::array<double, 3>& middle) {
  return reynolds_velocities_in_box(swimmer, 1, {.box = box, .middle_bead = middle}, some_force).value();
}

Eigen::Vector3d in_box(const CollinearSwimmer& swimmer, const Box& box) {
  const Vec3 middle = box.lengths / 2;
  return in_box(swimmer, box, {middle[0], middle[1], middle[2]});
}

// The error is that of the mesh, and of images at a distance of 55 radii.
TEST(ReynoldsVelocitiesInBox, ApproachThoseInOpenSpace) {
  constexpr double mesh_and_images = 0.04;
  for (const CollinearSwimmer& swimmer : {paper_swimmer(700), paper_swimmer(1500), unequal_swimmer()}) {
    const Eigen::Vector3d towing = towing_forces(rest_mobility(swimmer, rotne_prager).value);
    const double open = reynolds_stress_velocity(reynolds_stress_form(swimmer, 1, towing).total, some_force);
    EXPECT_NEAR(towing.dot(in_box(swimmer, periodic_box(260, 220, 220))) / open, 1, mesh_and_images);
  }
}

// Images at two walls on both sides of the swimmer are those of a periodic box.
TEST(ReynoldsVelocitiesInBox, BetweenWallsAlongTheSwimmerAreThoseInAPeriodicBox) {
  const CollinearSwimmer swimmer = unequal_swimmer();
  Box walls = periodic_box(80, 40, 32);
  walls.boundary = {Boundary::periodic, Boundary::free_slip, Boundary::free_slip};
  const Eigen::Vector3d periodic = in_box(swimmer, periodic_box(80, 40, 32));
  EXPECT_LT((in_box(swimmer, walls) - periodic).norm(), 1e-10 * periodic.norm());
}

// A swimmer that is its own mirror image, midway between walls across it: the images are those of a periodic
// box.
TEST(ReynoldsVelocitiesInBox, BetweenWallsAcrossASymmetricSwimmerAreThoseInAPeriodicBox) {
  const Eigen::Vector3cd opposite(some_force[0], Complex(0), -some_force[0]);
  const auto velocities = [&](const Box& box) {
    return reynolds_velocities_in_box(paper_swimmer(2000), 1, {.box = box, .middle_bead = {48, 20, 20}},
                                      opposite)
        .value();
  };
  const Eigen::Vector3d periodic = velocities(periodic_box(96, 40, 40));
  EXPECT_GT(std::abs(periodic[0]), 1e-9);
  EXPECT_LT((velocities(walled_box(96, 40, 40)) - periodic).norm(), 1e-10 * periodic.norm());
}

// A wall across the swimmer mirrors it: a swimmer that swims away from its image is the mirror image of one
// that swims away from the other wall.
TEST(ReynoldsVelocitiesInBox, BetweenWallsAcrossTheSwimmerChangeSignWithTheScene) {
  const CollinearSwimmer swimmer = paper_swimmer(2000);
  const Box walls = walled_box(80, 40, 40);
  const Eigen::Vector3d velocity = in_box(swimmer, walls, {34, 18, 21});
  const Eigen::Vector3cd force = -some_force.reverse();
  const Eigen::Vector3d mirrored =
      reynolds_velocities_in_box(swimmer, 1, {.box = walls, .middle_bead = {46, 18, 21}}, force).value();
  EXPECT_LT((velocity + mirrored.reverse()).norm(), 1e-3 * velocity.norm());
}

TEST(ReynoldsVelocitiesInBox, DoNotDependOnThePlaceOfTheSwimmerInAPeriodicBox) {
  const CollinearSwimmer swimmer = unequal_swimmer();
  const Box box = periodic_box(80, 40, 32);
  const Eigen::Vector3d velocity = in_box(swimmer, box, {40, 20, 16});
  EXPECT_LT((in_box(swimmer, box, {41.3, 19.1, 17.7}) - velocity).norm(), 1e-10 * velocity.norm());
}

TEST(ReynoldsVelocitiesInBox, AreLeftOutInLargeBoxes) {
  EXPECT_FALSE(reynolds_velocities_in_box(paper_swimmer(2000), 1,
                                          {.box = walled_box(1200, 800, 800), .middle_bead = {600, 400, 400}},
                                          some_force));
}

}  // namespace
}  // namespace beadswim
