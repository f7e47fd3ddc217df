#include <gtest/gtest.h>

#include <cmath>

#include "swimming.hpp"

// Tests of swimmers in boxes. They are slow, because their mobility products have many exact digits.

namespace beadswim {
namespace {

// Ewald's sum along the line against that in space; a swimmer between walls across its axis feels their
// images.
TEST(OverdampedSwimmer, SwimsAsHarmonicBalanceSaysInBoxes) {
  constexpr int steps = 300;
  constexpr double truncation = 5e-5;
  OverdampedScene scene = scene_of(paper_swimmer(), steps);
  scene.tolerance = 1e-6;
  scene.domain.box = Box{{120, 80, 80}, {}};
  expect_theory(scene, steps, 3, truncation);
  scene.domain.box = Box{{100, 40, 40}, {Boundary::periodic, Boundary::free_slip, Boundary::periodic}};
  scene.swimmers[0].position = {50, 20, 20};
  expect_theory(scene, steps, 3, truncation);
}

// Quasi-static v/v_free of the paper's swimmer at small amplitude, by sums along a line.
TEST(OverdampedSwimmer, HasTheBoxFactorsOnRecord) {
  struct Case {
    Vec3 lengths;
    bool has_walls;
    double factor, printed_digits;
  };
  constexpr int steps = 100;
  ThreeBeadSwimmer type = paper_swimmer();
  type.driving.amplitude = {0.01, 0.01};
  OverdampedScene scene = scene_of(type, steps);
  scene.tolerance = 1e-8;  // the swimmer is a thousandth as fast as its beads
  const double open = swimming_of(scene, steps, 3).velocity;
  for (const auto& [lengths, has_walls, factor, printed_digits] :
       {Case{{60, 60, 60}, false, 1.3228, 1e-4}, Case{{100, 100, 100}, false, 1.0287, 1e-4},
        Case{{100, 40, 40}, false, 0.768, 1e-3}, Case{{160, 80, 80}, true, 0.99226, 1e-4}}) {
    scene.domain.box = Box{.lengths = lengths};
    scene.domain.box->boundary.fill(has_walls ? Boundary::free_slip : Boundary::periodic);
    scene.swimmers[0].position = lengths / 2;
    EXPECT_NEAR(swimming_of(scene, steps, 3).velocity / open, factor, printed_digits) << lengths.transpose();
  }
}

// A cell that repeats: what one swimmer does in it each of eight does in a box of 2 x 2 x 2 cells, to
// roundoff where the product is as exact.
TEST(OverdampedSwarm, OfEightCellsMovesAsOfOne) {
  constexpr int steps = 40;
  OverdampedScene one = scene_of(paper_swimmer(), steps);
  set_amplitude(one.types[0].driving, {1, 1});
  for (Bond& bond : one.types[0].bonds) bond.stiffness = 0.2;
  one.domain.box = Box{{64, 32, 32}, {}};
  one.swimmers[0].position = {32, 16, 16};
  one.tolerance = 1e-12;
  OverdampedScene eight = one;
  eight.domain.box = Box{{128, 64, 64}, {}};
  eight.swimmers.clear();
  for (int id = 0; id < 8; ++id)
    eight.swimmers.push_back(
        {.id = id,
         .type = 0,
         .position = Vec3(32 + 64 * (id & 1), 16 + 32 * (id >> 1 & 1), 16 + 32 * (id >> 2))});
  const auto cell = positions_after(one, 10), swarm = positions_after(eight, 10);
  EXPECT_GT(std::abs(cell[0][0] - 12), 0.02);
  for (std::size_t b = 0; b < swarm.size(); ++b) {
    const Vec3 offset = eight.swimmers[b / 3].position - one.swimmers[0].position;
    EXPECT_LT((swarm[b] - offset - cell[b % 3]).norm(), 5e-12) << "bead " << b;
  }
}

// Neighbours 2.67 radii apart answer to each other's springs more than to their own. Few steps a cycle do,
// and swimmers that are alike stay so.
TEST(OverdampedSwarm, BearsDenseSwarmsWithFewSteps) {
  OverdampedScene scene = scene_of(paper_swimmer(), 50);
  const double period = scene.types[0].driving.period, gap = 10.67;
  set_amplitude(scene.types[0].driving, {1, 1});
  for (Bond& bond : scene.types[0].bonds) bond.stiffness = 0.2;
  scene.tolerance = 1e-5;
  scene.domain.box = Box{{64, 4 * gap, 4 * gap}, {}};
  scene.swimmers.clear();
  for (int id = 0; id < 16; ++id)
    scene.swimmers.push_back(
        {.id = id, .type = 0, .position = Vec3(32, gap * (0.5 + id % 4), gap * (0.5 + id / 4))});
  const auto start = positions_after(scene, 0), few = positions_after(scene, 50);
  for (std::size_t b = 3; b < few.size(); ++b)
    EXPECT_LT((few[b] - start[b] - few[b % 3] + start[b % 3]).norm(), 1e-4) << "bead " << b;
  scene.step = period / 400;
  const auto many = positions_after(scene, 400);
  EXPECT_GT(farthest(start, many), 0.3);
  EXPECT_LT(farthest(few, many), 2e-3);
}

}  // namespace
}  // namespace beadswim
