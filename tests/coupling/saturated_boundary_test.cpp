#include "beadswim/coupling/saturated_cells.hpp"

#include <gtest/gtest.h>

#include <random>

#include "beadswim/coupling/saturated_cell.hpp"
#include "beadswim/lattice/trt.hpp"

namespace beadswim::test {
namespace {

const Index3 cells(20, 11, 10);
constexpr double viscosity = 0.4;

/// Beads in a block that is the complete periodic lattice.
struct Scene {
  explicit Scene(const std::vector<BeadOnLattice>& beads, Precision precision)
      : populations(cells, precision),
        saturated({.block = {.offset = Index3::Zero(), .size = cells}, .cells = cells, .boundary = {}},
                  viscosity),
        beads(beads) {
    saturated.find(beads);
  }

  void push() {
    for_each_row([&](int y, int z) { saturated.apply_forces_before_row(populations, beads, y, z); });
    saturated.transfer_impulses(beads);
  }

  /// Returns the momentum of all populations that stream into the cells.
  Vec3 incoming_momentum() const {
    Vec3 sum = Vec3::Zero();
    for_each_row([&](int y, int z) {
      for (int x = 0; x < cells[0]; ++x) sum += incoming_momentum(x, y, z);
    });
    return sum;
  }
  Vec3 incoming_momentum(int x, int y, int z) const {
    Vec3 sum = Vec3::Zero();
    for (int i = 1; i < d3q19::directions; ++i) {
      const auto& c = d3q19::velocity[i];
      sum += populations.incoming(i, populations.cell(x, y, z)) * Vec3(c[0], c[1], c[2]);
    }
    return sum;
  }

  void set_incoming(int i, int x, int y, int z, double f) {
    populations.set_outgoing(i, populations.cell(x, y, z) - populations.shift(i), f);
  }

  template <class Visit>
  static void for_each_row(Visit&& visit) {
    for (int z = 0; z < cells[2]; ++z) {
      for (int y = 0; y < cells[1]; ++y) visit(y, z);
    }
  }

  Populations populations;
  SaturatedCells saturated;
  std::vector<BeadOnLattice> beads;
};

BeadOnLattice bead(int number, const Vec3& position, const Vec3& velocity, const Vec3& angular_velocity) {
  return {.name = {0, number},
          .radius = 2.3,
          .motion = {.position = position, .velocity = velocity, .angular_velocity = angular_velocity},
          .impulse = {}};
}

/// Returns two rotating beads with a gap of 1/3 cell, so that some cells are partly in both beads.
std::vector<BeadOnLattice> close_beads() {
  return {bead(0, Vec3(7.1, 5.2, 4.7), Vec3(0.01, -0.02, 0.005), Vec3(0.002, 0.001, -0.003)),
          bead(1, Vec3(12.0, 5.4, 5.1), Vec3(-0.02, 0.01, 0.01), Vec3(0, -0.002, 0.001))};
}

class SaturatedBoundaryIn : public testing::TestWithParam<Precision> {};
INSTANTIATE_TEST_SUITE_P(Precisions, SaturatedBoundaryIn, testing::Values(Precision::fp64, Precision::fp32));

// Catches momentum that is handed over from numbers before they are rounded, or a shared cell whose momentum
// goes to one of its beads twice. Seed 1.
TEST_P(SaturatedBoundaryIn, HandsOverWhatTheLatticeGivesUp) {
  Scene scene(close_beads(), GetParam());
  std::mt19937 random(1);
  std::uniform_real_distribution<double> population(-0.01, 0.01);
  Scene::for_each_row([&](int y, int z) {
    for (int x = 0; x < cells[0]; ++x) {
      for (int i = 0; i < d3q19::directions; ++i) scene.set_incoming(i, x, y, z, population(random));
    }
  });
  const Vec3 before = scene.incoming_momentum();
  scene.push();
  Vec3 handed = Vec3::Zero();
  for (const BeadOnLattice& bead : scene.beads) handed += bead.impulse.fluid.value().force;
  EXPECT_GT(handed.norm(), 0.1);
  constexpr double roundoff = 1e-13;  // of double precision, whatever that of the populations
  EXPECT_LT((scene.incoming_momentum() - before + handed).norm(), roundoff);
}

// Catches a shared cell that treats one of its beads differently: mirrored beads in a mirrored flow.
TEST(SaturatedBoundary, SharedByMirroredBeadsHandsThemMirroredImpulses) {
  const Vec3 v(0.01, 0.02, 0);
  Scene scene({bead(0, Vec3(10 - 2.4, 5.3, 4.9), v, Vec3::Zero()),
               bead(1, Vec3(10 + 2.4, 5.3, 4.9), Vec3(-v[0], v[1], 0), Vec3::Zero())},
              Precision::fp64);
  scene.push();
  const Load one = scene.beads[0].impulse.fluid.value(), other = scene.beads[1].impulse.fluid.value();
  constexpr double roundoff = 1e-14;
  EXPECT_LT((one.force - Vec3(-other.force[0], other.force[1], other.force[2])).norm(), roundoff);
  EXPECT_LT((one.torque - Vec3(other.torque[0], -other.torque[1], -other.torque[2])).norm(), roundoff);
  EXPECT_LT(one.force[1], -0.1);
}

// Full cells: equilibrium stays equilibrium, at a velocity nearer to the bead's by the rate of the law.
// Catches a population that is pushed along the wrong direction, or by other terms of second order.
TEST(SaturatedBoundary, MovesEquilibriumToEquilibrium) {
  const Vec3 u(0.03, -0.01, 0.02);
  Scene scene({bead(0, Vec3(7.1, 5.2, 4.7), Vec3(0.01, -0.02, 0.005), Vec3(0.002, 0.001, -0.003))},
              Precision::fp64);
  Scene::for_each_row([&](int y, int z) {
    for (int x = 0; x < cells[0]; ++x) {
      for (int i = 0; i < d3q19::directions; ++i)
        scene.set_incoming(i, x, y, z, equilibrium(i, 0.01, u[0], u[1], u[2]));
    }
  });
  scene.push();
  const Vec3 from_centre(0.4, 0.3, -0.2);  // of cell (7, 5, 4), a full one
  const double rate = forcing_rate(3 * viscosity * resistance(1.0));
  const Vec3 pushed = u + rate * (scene.beads[0].velocity_at(from_centre) - u);
  for (int i = 0; i < d3q19::directions; ++i) {
    EXPECT_NEAR(scene.populations.incoming(i, scene.populations.cell(7, 5, 4)),
                equilibrium(i, 0.01, pushed[0], pushed[1], pushed[2]), 1e-16);
  }
}

}  // namespace
}  // namespace beadswim::test
