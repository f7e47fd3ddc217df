#include <gtest/gtest.h>

#include <cmath>

#include "beadswim/overdamped/contacts.hpp"
#include "beadswim/swimmers/swimmer_forces.hpp"
#include "direct_ewald.hpp"
#include "scenes.hpp"

namespace beadswim {
namespace {

direct::Spheres spheres_of(const OverdampedScene& scene, const direct::Vectors& places, double time) {
  direct::Spheres spheres{places, bead_radii(scene), {}};
  for (std::size_t s = 0; s < scene.swimmers.size(); ++s) {
    const SwimmerType& type = scene.type_of(scene.swimmers[s]);
    BeadVectors beads(3, 3);
    beads << places[3 * s], places[3 * s + 1], places[3 * s + 2];
    const BeadVectors forces = bond_forces(type, time, beads, BeadVectors::Zero(3, 3)) +
                               angle_forces(type, time, beads) +
                               driving_forces(type, time, beads, scene.swimmers[s].orientation);
    for (int b = 0; b < 3; ++b) spheres.forces.push_back(forces.col(b));
  }
  return spheres;
}

// Two swimmers that are driven into each other across a seam of the box do as in its middle.
TEST(OverdampedSwarm, TouchesAcrossSeamsAsWithin) {
  OverdampedScene scene = scene_of(paper_swimmer(), 100);
  set_amplitude(scene.types[0].driving, {0.5, 0.5});
  scene.tolerance = 1e-6;
  scene.domain.box = Box{{80, 40, 40}, {}};
  scene.swimmers[0].position = {40, 20, 20};
  scene.swimmers.push_back({.id = 1,
                            .type = 0,
                            .position = {52, 28.4, 20},
                            .orientation = shortest_turn(Vec3(1, -0.3, 0).normalized())});
  const auto within = positions_after(scene, 80);
  const std::array<Vec3, 2> shifts{Vec3(37, 16, 19), Vec3(37, 16 - 40, 19)};  // to either side of the box
  for (int s : {0, 1}) scene.swimmers[s].position += shifts[s];
  const Communicator world(MPI_COMM_WORLD);
  OverdampedSystem system(scene, world);
  for (int n = 0; n < 80; ++n) system.step();
  ASSERT_FALSE(system.fault());
  EXPECT_LT(system.state().smallest_gap, 0.7);
  for (std::size_t b = 0; b < within.size(); ++b)
    EXPECT_LT((system.positions()[b] - shifts[b / 3] - within[b]).norm(), 1e-4) << "bead " << b;
}

/// Returns the force dipole sum F_x x of one swimmer, averaged over the third cycle. The forces follow from
/// bead positions and time.
double mean_dipole(const OverdampedScene& scene, int steps_per_cycle) {
  const Communicator world(MPI_COMM_WORLD);
  OverdampedSystem system(scene, world);
  double dipole = 0;
  for (int n = 0; n < 3 * steps_per_cycle; ++n) {
    if (n >= 2 * steps_per_cycle) {
      const direct::Vectors places(system.positions().begin(), system.positions().end());
      const direct::Spheres spheres = spheres_of(scene, places, system.time());
      for (int b = 0; b < 3; ++b)
        dipole += spheres.forces[b][0] * (places[b] - places[1])[0] / steps_per_cycle;
    }
    system.step();
  }
  return dipole;
}

/// Returns the velocity with which the middle beads of two swimmers move apart in the third cycle.
Vec3 parting(OverdampedScene scene, const Vec3& separation, int steps_per_cycle) {
  scene.swimmers.push_back(scene.swimmers[0]);
  scene.swimmers[1].id = 1;
  scene.swimmers[1].position += separation;
  const auto before = positions_after(scene, 2 * steps_per_cycle),
             after = positions_after(scene, 3 * steps_per_cycle);
  return ((after[4] - after[1]) - (before[4] - before[1])) / scene.types[0].driving.period;
}

// Far apart two swimmers see each other's mean force dipole D: in line they part at D/(2 pi eta R^2), side by
// side at -D/(4 pi eta R^2), the flow of two opposite forces; next orders are 1/R of it. Neither cycle nor
// stroke enters.
TEST(OverdampedSwarm, PartsAsTheDipolesFarFieldSays) {
  constexpr int steps = 200;
  OverdampedScene scene = scene_of(paper_swimmer(), steps);
  set_amplitude(scene.types[0].driving, {0.3, 0.1});  // by symmetry alike forces have a small dipole only
  const double dipole = mean_dipole(scene, steps), eta = scene.viscosity;
  const auto error = [&](double r) {
    const double in_line = parting(scene, {r, 0, 0}, steps)[0] / (dipole / (2 * pi * eta * r * r));
    const double abreast = parting(scene, {0, r, 0}, steps)[1] / (-dipole / (4 * pi * eta * r * r));
    return std::pair(std::abs(in_line - 1), std::abs(abreast - 1));
  };
  const auto [near_line, near_abreast] = error(1000);
  const auto [far_line, far_abreast] = error(4000);
  constexpr double next_order = 0.02;
  EXPECT_LT(far_line, next_order);
  EXPECT_LT(far_abreast, next_order);
  EXPECT_LT(far_line, 0.5 * near_line + 1e-4);
  EXPECT_LT(far_abreast, 0.5 * near_abreast + 1e-4);
}

// Beads of two swimmers that overlap at the start part, and no step is undone by it; torn arms are told of.
TEST(OverdampedSwarm, PartsBeadsThatTouch) {
  OverdampedScene scene = scene_of(paper_swimmer(), 200);
  scene.swimmers.push_back({.id = 1, .type = 0, .position = scene.swimmers[0].position + Vec3(0, 7.9, 0)});
  const Communicator world(MPI_COMM_WORLD);
  OverdampedSystem system(scene, world);
  for (int n = 0; n < 400; ++n) system.step();
  ASSERT_FALSE(system.fault());
  for (int b = 0; b < 3; ++b) EXPECT_GT((system.positions()[b] - system.positions()[3 + b]).norm(), 8.0);
}

// Beads of a swimmer whose gap at rest is a tenth of a radius do not repel each other at rest; beads of
// different swimmers do at this gap, whatever the types of the scene.
TEST(OverdampedSwarm, RepelsNoBeadsOfASwimmerAtRest) {
  ThreeBeadSwimmer close = paper_swimmer();
  for (Spring& spring : close.springs) spring.rest_length = 8.4;
  OverdampedScene scene = scene_of(close, 200);
  scene.types.push_back(swimmer_type(paper_swimmer()));
  const Vec3 place = scene.swimmers[0].position + Vec3(0, 100, 0);
  for (int s = 1; s < 3; ++s)
    scene.swimmers.push_back({.id = s, .type = 1, .position = place + Vec3(0, 8.4 * s, 0)});
  std::vector<double> radii;
  std::vector<Vec3> positions;
  for (const PlacedSwimmer& swimmer : scene.swimmers) {
    for (const BeadAtRest& bead : scene.type_of(swimmer).beads) {
      radii.push_back(bead.radius);
      positions.push_back(swimmer.position + bead.at);
    }
  }
  const std::vector<Contact> contacts = find_contacts(ContactScale(scene), {}, radii, positions);
  ASSERT_EQ(contacts.size(), 3U);
  for (const Contact& contact : contacts) {
    EXPECT_GE(std::min(contact.first, contact.second), 3);  // not beads of the first swimmer
    EXPECT_NEAR(contact.cutoff, 0.8, 1e-12);
  }
}

// Driven against a wall beads stay on their side of it.
TEST(OverdampedSwarm, StaysBetweenWalls) {
  OverdampedScene scene = scene_of(paper_swimmer(), 800);
  scene.domain.box = Box{{60, 40, 40}, {Boundary::free_slip, Boundary::free_slip, Boundary::free_slip}};
  set_amplitude(scene.types[0].driving, {0.8, 0.8});
  scene.tolerance = 1e-3;
  const Communicator world(MPI_COMM_WORLD);
  for (const double y : {4.05, 40 - 4.05}) {
    scene.swimmers[0].position = {24.05, y, 20};
    OverdampedSystem system(scene, world);
    for (int n = 0; n < 300; ++n) system.step();
    ASSERT_FALSE(system.fault()) << "y = " << y;
    EXPECT_GT(system.state().smallest_gap, 0) << "y = " << y;
    EXPECT_LT(system.state().smallest_gap, 0.4) << "y = " << y;
  }
}

/// Returns the smallest gap, and the mean velocity of swimmer 0 along x in the second cycle.
std::pair<double, double> gap_and_speed(OverdampedScene scene, int steps_per_cycle) {
  const double period = scene.types[0].driving.period;
  scene.step = period / steps_per_cycle;
  const Communicator world(MPI_COMM_WORLD);
  OverdampedSystem system(scene, world);
  double start = 0;
  for (int n = 0; n < 2 * steps_per_cycle; ++n) {
    if (n == steps_per_cycle) start = system.positions()[1][0];
    system.step();
  }
  EXPECT_FALSE(system.fault()) << "with " << steps_per_cycle << " steps";
  return {system.state().smallest_gap, (system.positions()[1][0] - start) / period};
}

// Contacts with a wall and with another swimmer are found where beads end, not where they were expected.
TEST(OverdampedSwarm, MeetsWallsAndOthersInFewSteps) {
  OverdampedScene wall = scene_of(paper_swimmer(), 50);
  set_amplitude(wall.types[0].driving, {0.5, 0.5});
  wall.tolerance = 1e-4;
  wall.domain.box = Box{{60, 40, 40}, {Boundary::free_slip, Boundary::periodic, Boundary::periodic}};
  wall.swimmers[0].position = {26, 20, 20};
  OverdampedScene others = scene_of(paper_swimmer(), 50);
  set_amplitude(others.types[0].driving, {0.5, 0.5});
  others.tolerance = 1e-6;
  others.swimmers.push_back({.id = 1, .type = 0, .position = {109.5, 40, 41}});
  others.swimmers[0].position = {60, 40, 40};
  for (const OverdampedScene& scene : {wall, others}) {
    const auto [gap, speed] = gap_and_speed(scene, 50);
    const auto [fine_gap, fine_speed] = gap_and_speed(scene, 800);
    EXPECT_LT(fine_gap, 0.75);  // they did meet
    EXPECT_NEAR(gap, fine_gap, 0.03);
    EXPECT_NEAR(speed / fine_speed, 1, 0.02);
  }
}

// Places of the first step are extrapolated, which the stiffest of forces must not take for stretch.
TEST(OverdampedSwarm, BeginsGentlyWithStiffSprings) {
  OverdampedScene scene = scene_of(paper_swimmer(), 100);
  scene.swimmers[0].orientation = shortest_turn(Vec3(1, 1, 0).normalized());
  for (Bond& bond : scene.types[0].bonds) bond.stiffness *= 1e5;
  const Communicator world(MPI_COMM_WORLD);
  OverdampedSystem system(scene, world);
  const double at_rest = system.state().largest_speed;
  for (int n = 0; n < 4; ++n) system.step();
  ASSERT_FALSE(system.fault());
  EXPECT_LT(system.state().largest_speed, 1.5 * std::max(at_rest, system.velocities()[0].norm()));
}

// Numbers that are none are told of, in the first steps too.
TEST(OverdampedSwarm, StopsAtNumbersThatAreNone) {
  OverdampedScene scene = scene_of(paper_swimmer(), 100);
  set_amplitude(scene.types[0].driving, {1e160, 1e160});
  const Communicator world(MPI_COMM_WORLD);
  OverdampedSystem system(scene, world);
  for (int n = 0; n < 5; ++n) system.step();
  ASSERT_TRUE(system.fault());
}

TEST(OverdampedSwarm, StopsAtATornArm) {
  OverdampedScene scene = scene_of(paper_swimmer(), 400);
  set_amplitude(scene.types[0].driving, {6, 6});
  const Communicator world(MPI_COMM_WORLD);
  OverdampedSystem system(scene, world);
  for (int n = 0; n < 400 && !system.fault(); ++n) system.step();
  ASSERT_TRUE(system.fault());
  EXPECT_EQ(system.fault()->kind, FaultKind::torn_arm);
  const Vec3 stopped = system.positions()[0];
  system.step();
  EXPECT_EQ(system.positions()[0], stopped);
}

}  // namespace
}  // namespace beadswim
