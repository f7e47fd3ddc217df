#include <gtest/gtest.h>

#include "beadswim/collinear/multipole_mobility.hpp"
#include "beadswim/collinear/rotne_prager.hpp"
#include "beadswim/mobility/line_map.hpp"
#include "near_scenes.hpp"

namespace beadswim {
namespace {

// Two cells of the box as one of twice the size, an edge of which two images of a bead are near: all images
// within reach count, not the nearest alone. A bead on either side of a seam, and whole edges away.
TEST(NearFieldImages, CountsAllImagesInAPeriodicBox) {
  Crowd crowd(7, 2, {7, 8, 9});
  const MobilityScene cell = near_scene(crowd.radii, Box{{7, 8, 9}, {}});
  const Vectors expected = velocities(cell, crowd.places, crowd.forces);
  Vectors places = crowd.places, forces = crowd.forces;
  Numbers radii = crowd.radii;
  for (std::size_t b = 0; b < crowd.places.size(); ++b) {
    places.push_back(crowd.places[b] + Vec3(7 - (b / 3 % 2 == 0 ? 28 : 0), 0, 0));
    forces.push_back(crowd.forces[b]);
    radii.push_back(crowd.radii[b]);
  }
  const Vectors found = velocities(near_scene(radii, Box{{14, 8, 9}, {}}), places, forces);
  constexpr double of_sums = 1e-7;
  for (std::size_t b = 0; b < places.size(); ++b)
    EXPECT_LT((found[b] - expected[b % expected.size()]).norm(), of_sums) << "bead " << b;
  for (Vec3& place : crowd.places) place += Vec3(3.3, 5, 7);
  EXPECT_LT(largest_difference(velocities(cell, crowd.places, crowd.forces), expected), of_sums);
}

// Walls are mirrors: the box of beads and their copies, twice as long, has the same velocities.
TEST(NearFieldImages, CountsMirrorImagesBehindWalls) {
  const Crowd crowd(8, 3, {9, 8, 9});
  const Vectors expected = velocities(
      near_scene(crowd.radii, Box{{9, 8, 9}, {Boundary::free_slip, Boundary::periodic, Boundary::free_slip}}),
      crowd.places, crowd.forces);
  Vectors places = crowd.places, forces = crowd.forces;
  Numbers radii = crowd.radii;
  for (const int a : {0, 2}) {
    const std::size_t count = places.size();
    for (std::size_t b = 0; b < count; ++b) {
      places.push_back(places[b]);
      forces.push_back(forces[b]);
      radii.push_back(radii[b]);
      places.back()[a] *= -1;
      forces.back()[a] *= -1;
    }
  }
  const Vectors found = velocities(near_scene(radii, Box{{18, 8, 18}, {}}), places, forces);
  constexpr double of_sums = 1e-7;
  for (std::size_t b = 0; b < expected.size(); ++b)
    EXPECT_LT((found[b] - expected[b]).norm(), of_sums) << "bead " << b;
}

// A bead driven at a free-slip wall, against the exact mobility of it and its image. The box, far larger than
// the two, slows Rotne and Prager's; S then changes this part as it changes the mobility with stresslets.
TEST(NearFieldImages, MovesABeadAtAWallAsItsImageHasIt) {
  constexpr double strain = 5e-6;  // of both by the images far away
  const Numbers radii{1, 1, 1};
  for (const double gap : {0.05, 0.4, 1.5}) {
    const double to_wall = 1 + gap / 2;
    const Vectors places{{to_wall, 100, 100}, {70, 100, 100}, {135, 100, 100}};
    const Vectors forces{{1, 0, 0}, Vec3::Zero(), Vec3::Zero()};
    MobilityScene scene = near_scene(
        radii, Box{{200, 200, 200}, {Boundary::free_slip, Boundary::periodic, Boundary::periodic}});
    const double near = velocities(scene, places, forces)[0][0];
    scene.model = MobilityModel::rpy;
    const double plain = velocities(scene, places, forces)[0][0];
    const std::array two{1.0, 1.0}, line{0.0, 2 * to_wall};
    const Eigen::Vector2d opposite(-1, 1);
    const double exact = opposite.dot(multipole_mobility(two, line, eta).value * opposite) / 2;
    const double strained =
        opposite.dot(strained_line<2>(two, line, eta, [](double) { return 1.0; }) * opposite) / 2;
    const double alone = self_mobility(1, eta) - rotne_prager(1, 1, 2 * to_wall, eta).value;
    EXPECT_NEAR(near / (exact + (plain - alone) * exact / strained), 1, strain) << "gap " << gap;
    EXPECT_LT(near / plain, 0.99);
  }
}

}  // namespace
}  // namespace beadswim
