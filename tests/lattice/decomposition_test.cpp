// Tests on several ranks: the state of the lattice must not depend on its decomposition into blocks.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "beadswim/core/error.hpp"
#include "beadswim/lattice/totals.hpp"
#include "fluid_box.hpp"

namespace beadswim::test {
namespace {

constexpr std::array<Boundary, 3> all_periodic{Boundary::periodic, Boundary::periodic, Boundary::periodic};

/// Returns an irregular state of a cell, which depends only on the global coordinates of the cell.
CellMoments rough_state(const Index3& cell) {
  std::mt19937 random(static_cast<unsigned>(cell[0] + 1000 * cell[1] + 1000000 * cell[2]));
  std::uniform_real_distribution<double> deviation(-0.02, 0.02);
  const double density = deviation(random), ux = deviation(random), uy = deviation(random);
  return {density, Vec3(ux, uy, deviation(random))};
}

/// Lattices with different numbers of cells along z. With 8 cells no plane is inside a block, so that none
/// can be swept while messages are in transit; with 24 cells some planes are.
class Decomposed : public testing::TestWithParam<std::tuple<std::array<Boundary, 3>, Precision, int>> {};

// Catches any exchange that is missing or out of order, at faces, edges and wall corners alike, and row ends
// that the sweep fills otherwise than the halo does: the block of one piece leaves them to the halo.
TEST_P(Decomposed, GivesTheBitsOfOneBlock) {
  const auto [walls, precision, planes] = GetParam();
  const Index3 cells(9, 7, planes);
  FluidBox cut(cells, walls, 1.1, MPI_COMM_WORLD, precision);
  FluidBox whole(cells, walls, 1.1, MPI_COMM_SELF, precision);
  whole.row_ends = RowEnds::left_to_halo;
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

INSTANTIATE_TEST_SUITE_P(
    Walls, Decomposed,
    testing::Combine(testing::Values(all_periodic,
                                     std::array{Boundary::free_slip, Boundary::free_slip,
                                                Boundary::free_slip},
                                     std::array{Boundary::no_slip, Boundary::no_slip, Boundary::no_slip},
                                     std::array{Boundary::periodic, Boundary::no_slip, Boundary::free_slip},
                                     std::array{Boundary::free_slip, Boundary::periodic, Boundary::no_slip}),
                     testing::Values(Precision::fp64, Precision::fp32), testing::Values(8, 24)));

// Catches row ends that are believed although a cell there has been set since the sweep.
TEST(RowEnds, AreFilledAnewAfterACellThereWasSet) {
  FluidBox box(Index3(9, 3, 2), all_periodic, 1.1);
  box.set(rough_state);
  box.steps(3);
  const std::ptrdiff_t last = box.populations.cell(8, 1, 1), image = box.populations.cell(-1, 1, 1);
  const int along_x = d3q19::direction_of(1, 0, 0);
  box.populations.set_outgoing(along_x, last, 0.0123);
  box.halo.start(box.populations);
  box.halo.finish(box.populations);
  EXPECT_EQ(box.populations.outgoing(along_x, image), 0.0123);
}

/// Returns the relative change of the momentum of a uniform flow that carries a slowly decaying shear wave.
double lost_momentum(Precision precision, int steps) {
  constexpr int n = 64;
  constexpr double slow_decay = 0.51;  // relaxation time: the wave falls by half in some 20,000 steps
  FluidBox box(Index3(n, 3, 2), all_periodic, slow_decay, MPI_COMM_SELF, precision);
  const Vec3 flow(0.03, -0.011, 0.007);
  box.set([&](const Index3& cell) {
    const double wave = 0.02 * std::sin(2 * std::numbers::pi / n * (cell[0] + 0.5));
    return CellMoments{.density_deviation = 0, .momentum = flow + Vec3(0, wave, wave)};
  });
  const Vec3 before = block_totals(box.populations).momentum_value();
  box.steps(steps);
  return (block_totals(box.populations).momentum_value() - before).norm() / before.norm();
}

// Weights and rates enter the collision without rounding; what is left is the rounding of populations, with
// either sign (measured: 2e-16 and 5e-7). Catches a rounded weight, with which double precision loses 7e-14.
TEST(FlowWithAWave, KeepsItsMomentum) {
  EXPECT_LT(lost_momentum(Precision::fp64, 20000), 5e-15);
  EXPECT_LT(lost_momentum(Precision::fp32, 20000), 5e-6);
}

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

/// Returns true if blocks of this thickness exist: tries all grids.
bool has_grid(const Index3& cells, int ranks, int thickness) {
  for (int x = 1; x <= ranks; ++x)
    for (int y = 1; x * y <= ranks; ++y)
      if (ranks % (x * y) == 0 && (cells / thickness >= Index3(x, y, ranks / (x * y))).all()) return true;
  return false;
}

// Catches the cheapest of all grids, whose blocks may be too thin, in place of the cheapest that fits.
TEST(Decomposition, FindsAGridOfThickBlocksIfThereIsOne) {
  const Index3 cells(40, 12, 12);
  for (int ranks = 1; ranks <= 800; ++ranks) {
    const auto divide = [&] { return Decomposition(Block{.size = cells}, ranks, 2); };
    if (!has_grid(cells, ranks, 2)) {
      EXPECT_THROW(divide(), InputError) << ranks;
      continue;
    }
    const Decomposition decomposition = divide();
    for (int r = 0; r < ranks; ++r) EXPECT_GE(decomposition.block(r).size.minCoeff(), 2) << ranks;
  }
}

// Every level must have a grid: 9 ranks fit the first lattice only, 4 ranks fit both.
TEST(Decomposition, NamesANumberOfRanksThatFits) {
  const auto refusal = [](const std::vector<SharedCells>& lattices, int ranks) -> std::string {
    try {
      require_grids(lattices, ranks);
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_THAT(refusal({{.cells = {2, 2, 1}}}, 5),
              testing::EndsWith("at least 1 along each axis; use ranks 4"));
  EXPECT_THAT(
      refusal({{.cells = {6, 3, 1}}, {.cells = {4, 4, 3}, .thickness = 2}}, 9),
      testing::EndsWith("share 4 x 4 x 3 cells, because each block needs at least 2 along each axis; use "
                        "ranks 4 or another bead boundary"));
  EXPECT_THAT(refusal({{.cells = {4, 4, 1}, .thickness = 2}}, 1),
              testing::EndsWith("use another bead boundary"));
}

}  // namespace
}  // namespace beadswim::test
