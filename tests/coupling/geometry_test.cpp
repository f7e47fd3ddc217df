#include <gtest/gtest.h>

#include <numbers>
#include <random>
#include <set>

#include "beadswim/coupling/bead_corrections.hpp"
#include "beadswim/coupling/bead_images.hpp"
#include "beadswim/coupling/scene_on_lattice.hpp"
#include "beadswim/lattice/trt.hpp"
#include "beadswim/swimmers/swimmer_dynamics.hpp"
#include "beadswim/swimmers/three_bead_swimmer.hpp"

namespace beadswim {
namespace {

/// Pairs (cell, image) of a block and its halo for which the cell lies in the image of a bead, found by a
/// search over all cells and all images.
using Covered = std::set<std::array<int, 6>>;

Covered covered_by_search(const BlockInLattice& at, const Vec3& position, double radius) {
  Covered covered;
  const Index3 n = at.block.size;
  for (int z = -1; z <= n[2]; ++z) {
    for (int y = -1; y <= n[1]; ++y) {
      for (int x = -1; x <= n[0]; ++x) {
        for (int i = 0; i < 9 * 9 * 9; ++i) {
          const Index3 k(i % 9 - 4, i / 9 % 9 - 4, i / 81 - 4);
          const Index3 unwrapped = Index3(x, y, z) + at.block.offset + k * at.cells;
          if ((unwrapped.cast<double>().matrix() + Vec3::Constant(0.5) - position).norm() < radius) {
            covered.insert({x, y, z, unwrapped[0], unwrapped[1], unwrapped[2]});
          }
        }
      }
    }
  }
  return covered;
}

Covered covered_by_images(const BlockInLattice& at, const Vec3& position, double radius) {
  Covered covered;
  for_each_image(at, 1, position, radius, [&](const BeadImage& image) {
    for (int z = image.low[2]; z < image.high[2]; ++z) {
      for (int y = image.low[1]; y < image.high[1]; ++y) {
        for (int x = image.low[0]; x < image.high[0]; ++x) {
          const Index3 unwrapped = Index3(x, y, z) + image.shift;
          if ((unwrapped.cast<double>().matrix() + Vec3::Constant(0.5) - position).norm() < radius) {
            covered.insert({x, y, z, unwrapped[0], unwrapped[1], unwrapped[2]});
          }
        }
      }
    }
  });
  return covered;
}

// Catches an image missed at a face, an edge, a corner or many periods away. Seed 1.
TEST(BeadImages, AreThoseFoundBySearchingAllCells) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> coordinate(-22, 22);
  for (const int rank : {0, 1, 3}) {
    const Index3 cells(9, 8, 7);
    const BlockInLattice at{.block = Decomposition(cells, 4).block(rank),
                            .cells = cells,
                            .boundary = {Boundary::periodic, Boundary::periodic, Boundary::periodic}};
    for (int trial = 0; trial < 60; ++trial) {
      const Vec3 position(coordinate(random), coordinate(random), coordinate(random));
      ASSERT_EQ(covered_by_images(at, position, 2.3), covered_by_search(at, position, 2.3))
          << position.transpose();
    }
  }
}

// At the paper's own resolution the lattice's numbers are the layout's.
TEST(LatticeScales, AreOneAtThePapersOwnResolution) {
  const LatticeChoice choice = choose_lattice(4, {4, 1.5}, {1, 1.0 / 3}, 4800);
  EXPECT_EQ(choice.scales.length, 1);
  EXPECT_EQ(choice.scales.time, 1);
  EXPECT_EQ(choice.relaxation_time, 1.5);
  EXPECT_EQ(choice.steps_per_period, 4800);
}

// Dimensionless numbers are the same in both units, and a period is a whole number of steps.
TEST(LatticeScales, KeepDimensionlessNumbers) {
  ThreeBeadSwimmer type;
  type.beads.fill({.radius = 2.5e-6, .density = 1100});
  type.springs.fill({.stiffness = 3e-6, .rest_length = 14e-6, .damping = 2e-9});
  type.angular_stiffness = 5e-15;
  type.driving = {.amplitude = {4e-12, 5e-12}, .phase = 1, .period = 0.0123, .frame = DrivingFrame::lab};
  const double nu = 1e-6, rho = 998;
  const LatticeChoice choice = choose_lattice(2.5e-6, {5, 0.9}, {rho, nu}, type.driving.period);
  const ThreeBeadSwimmer lattice = three_beads(in_units(swimmer_type(type), choice.scales));
  const double nu_lu = lattice_viscosity(choice.relaxation_time);

  constexpr double roundoff = 1e-12;
  const auto expect_same = [&](double si, double lu) { EXPECT_NEAR(lu / si, 1, roundoff); };
  expect_same(type.driving.amplitude[0] / (rho * nu * nu), lattice.driving.amplitude[0] / (nu_lu * nu_lu));
  expect_same(type.springs[0].stiffness * type.driving.period / (rho * nu * 2.5e-6),
              lattice.springs[0].stiffness * lattice.driving.period / (nu_lu * lattice.beads[0].radius));
  expect_same(type.springs[0].damping / (rho * nu * 2.5e-6),
              lattice.springs[0].damping / (nu_lu * lattice.beads[0].radius));
  expect_same(type.angular_stiffness / (rho * nu * nu * 2.5e-6),
              lattice.angular_stiffness / (nu_lu * nu_lu * lattice.beads[0].radius));
  expect_same(1100.0 / 998, lattice.beads[0].density);
  expect_same(static_cast<double>(choice.steps_per_period), lattice.driving.period);
  EXPECT_NEAR(choice.relaxation_time, 0.9, 0.01);
}

// A lone bead's friction is 6 pi eta R; that it comes late takes 6 pi eta R t_d from its inertia.
TEST(ForceDelay, IsMadeUpForByMass) {
  constexpr double tau = 1.7, radius = 2.6;
  const Bead bead{.radius = radius, .density = 1.3};
  const double friction = 6 * std::numbers::pi * lattice_viscosity(tau) * radius;
  const double more = mass({.radius = radius, .density = delay_density(bead, tau)});
  EXPECT_NEAR(more / (friction * force_delay(tau)), 1, 1e-12);
}

}  // namespace
}  // namespace beadswim
