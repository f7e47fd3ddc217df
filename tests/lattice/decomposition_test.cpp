// Runs on several ranks: the lattice must not notice how it is cut.
#include <gtest/gtest.h>

#include <random>

#include "beadswim/core/error.hpp"
#include "beadswim/lattice/totals.hpp"
#include "fluid_box.hpp"

namespace beadswim::test {
namespace {

constexpr std::array<Wall, 3> all_periodic{Wall::periodic, Wall::periodic, Wall::periodic};

/// A rough state that is a function of the global cell alone.
CellMoments rough_state(const Index3& cell) {
  std::mt19937 random(static_cast<unsigned>(cell[0] + 1000 * cell[1] + 1000000 * cell[2]));
  std::uniform_real_distribution<double> deviation(-0.02, 0.02);
  const double density = deviation(random), ux = deviation(random), uy = deviation(random);
  return {density, Vec3(ux, uy, deviation(random))};
}

class Decomposed : public testing::TestWithParam<std::array<Wall, 3>> {};

// Catches any exchange that is missing or out of order, at faces, edges and wall corners alike.
TEST_P(Decomposed, GivesTheBitsOfOneBlock) {
  const Index3 cells(9, 7, 8);
  FluidBox cut(cells, GetParam(), 1.1, MPI_COMM_WORLD);
  FluidBox whole(cells, GetParam(), 1.1);
  cut.set(rough_state);
  whole.set(rough_state);
  cut.steps(20);
  whole.steps(20);
  for_each_cell(cut.populations, [&](const Index3& p, std::ptrdiff_t cell) {
    const std::ptrdiff_t twin = whole.populations.cell(p + cut.block.offset);
    for (int i = 0; i < d3q19::directions; ++i) {
      ASSERT_EQ(cut.populations.outgoing(i, cell), whole.populations.outgoing(i, twin)) << p.transpose();
    }
  });
}

INSTANTIATE_TEST_SUITE_P(Walls, Decomposed,
                         testing::Values(all_periodic,
                                         std::array{Wall::free_slip, Wall::free_slip, Wall::free_slip},
                                         std::array{Wall::no_slip, Wall::no_slip, Wall::no_slip},
                                         std::array{Wall::periodic, Wall::no_slip, Wall::free_slip},
                                         std::array{Wall::free_slip, Wall::periodic, Wall::no_slip}));

TEST(PeriodicBox, ConservesMassAndMomentum) {
  FluidBox box(Index3(8, 9, 7), all_periodic, 0.6, MPI_COMM_WORLD);
  box.set(rough_state);
  const FluidTotals before = sum_over_ranks(block_totals(box.populations), box.communicator);
  box.steps(200);
  const FluidTotals after = sum_over_ranks(block_totals(box.populations), box.communicator);
  constexpr double roundoff = 1e-14;  // 504 cells, 200 steps, terms of 0.02
  EXPECT_NEAR(after.density_deviation.value(), before.density_deviation.value(), roundoff);
  EXPECT_LT((after.momentum_value() - before.momentum_value()).norm(), roundoff);
  EXPECT_GT(before.momentum_value().norm(), 0.01);  // there was something to conserve
}

TEST(Decomposition, EveryCellHasTheOneOwnerThatHoldsIt) {
  for (const int ranks : {1, 2, 3, 4, 5, 6, 7, 8, 12, 16}) {
    const Index3 cells(13, 6, 5);
    const Decomposition decomposition(cells, ranks);
    EXPECT_EQ(decomposition.ranks(), ranks);
    int sum = 0;
    for (int r = 0; r < ranks; ++r) sum += decomposition.block(r).size.prod();
    EXPECT_EQ(sum, cells.prod());
    for (int x = 0; x < 13; ++x) {
      for (int y = 0; y < 6; ++y) {
        for (int z = 0; z < 5; ++z) {
          const Index3 cell(x, y, z);
          EXPECT_TRUE(decomposition.block(decomposition.rank_of_cell(cell)).contains(cell));
        }
      }
    }
  }
}

TEST(Decomposition, RefusesMoreRanksThanCellsCanShare) {
  EXPECT_THROW(Decomposition(Index3(2, 2, 1), 5), InputError);
}

}  // namespace
}  // namespace beadswim::test
