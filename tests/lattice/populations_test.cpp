#include "beadswim/lattice/populations.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <set>

namespace beadswim {
namespace {

/// Size of a box without symmetry. Its rows do not fill a whole number of cache lines.
const Index3 size(9, 5, 4);

class PopulationsOf : public testing::TestWithParam<Precision> {};

INSTANTIATE_TEST_SUITE_P(Precisions, PopulationsOf, testing::Values(Precision::fp64, Precision::fp32),
                         [](const auto& info) { return to_text(info.param); });

// The table of docs/method/in-place-streaming.md from outside. Catches a parity that is not switched, and a
// shift with the wrong sign.
TEST_P(PopulationsOf, IncomingIsTheNeighboursOutgoingAtEitherParity) {
  Populations populations(size, GetParam());
  for (int parity = 0; parity < 2; ++parity, populations.advance(RowEnds::left_to_halo)) {
    for (int i = 0; i < d3q19::directions; ++i) {
      const auto& c = d3q19::velocity[i];
      const std::ptrdiff_t cell = populations.cell(3, 2, 1);
      const std::ptrdiff_t neighbour = populations.cell(3 - c[0], 2 - c[1], 1 - c[2]);
      populations.set_outgoing(i, neighbour, i + 0.25);
      EXPECT_EQ(populations.incoming(i, cell), i + 0.25);
    }
  }
}

// What makes any order of cells right: a step writes where its own cell has read, and nowhere else.
TEST_P(PopulationsOf, ACellsNextPlacesAreThoseOfItsIncomingOnes) {
  Populations populations(size, GetParam());
  in_precision(GetParam(), [&]<class Real>() {
    for (int parity = 0; parity < 2; ++parity, populations.advance(RowEnds::left_to_halo)) {
      std::set<const Real*> all;
      for_each_cell(populations, [&](const Index3&, std::ptrdiff_t cell) {
        std::set<const Real*> read, written;
        for (int i = 0; i < d3q19::directions; ++i) {
          read.insert(populations.incoming_row<Real>(i, cell));
          written.insert(populations.next_outgoing_row<Real>(i, cell));
        }
        EXPECT_EQ(read, written);
        for (int i = 0; i < d3q19::directions; ++i)  // as the sweep assumes
          EXPECT_EQ(populations.next_outgoing_row<Real>(i, cell),
                    populations.incoming_row<Real>(d3q19::opposite(i), cell));
        all.insert(read.begin(), read.end());
      });
      EXPECT_EQ(all.size(), std::size_t(size.prod()) * d3q19::directions);
    }
  });
}

// Rows begin at a cache line if the halo and the padding of a row are short.
TEST_P(PopulationsOf, RowsAreAlignedWhereThatCostsLittleMemory) {
  in_precision(GetParam(), [&]<class Real>() {
    Populations aligned(Index3(120, 3, 3), GetParam()), dense(Index3(6, 3, 3), GetParam());
    aligned.advance(RowEnds::left_to_halo);
    for (int i = 0; i < d3q19::directions; ++i) {
      const auto address =
          reinterpret_cast<std::uintptr_t>(aligned.outgoing_row<Real>(i, aligned.cell(0, 2, 1)));
      EXPECT_EQ(address % 64, 0) << i;
    }
    EXPECT_EQ(aligned.pitch(1), 128);
    EXPECT_EQ(dense.pitch(1), 8);
    EXPECT_EQ(Populations(Index3(62, 3, 3), GetParam()).pitch(1), 64);
    EXPECT_EQ(Populations(Index3(64, 3, 3), GetParam()).pitch(1), 66);
  });
}

// The numbers themselves: what a step puts down is what the accessors read after it.
TEST_P(PopulationsOf, NextOutgoingIsOutgoingAfterTheStep) {
  Populations populations(size, GetParam());
  const std::ptrdiff_t cell = populations.cell(0, 4, 3);
  in_precision(GetParam(), [&]<class Real>() {
    for (int parity = 0; parity < 2; ++parity) {
      for (int i = 0; i < d3q19::directions; ++i)
        *populations.next_outgoing_row<Real>(i, cell) = static_cast<Real>(i + 0.5);
      populations.advance(RowEnds::left_to_halo);
      for (int i = 0; i < d3q19::directions; ++i) EXPECT_EQ(populations.outgoing(i, cell), i + 0.5);
    }
  });
}

// Catches a boundary condition that counts what it meant to store instead of what is stored.
TEST_P(PopulationsOf, SettersReturnWhatIsStored) {
  Populations populations(size, GetParam());
  const std::ptrdiff_t cell = populations.cell(2, 2, 2);
  constexpr double third = 1.0 / 3;
  const double stored = populations.set_outgoing(4, cell, third);
  EXPECT_EQ(stored, GetParam() == Precision::fp32 ? static_cast<double>(static_cast<float>(third)) : third);
  EXPECT_EQ(populations.outgoing(4, cell), stored);
}

// The bulk's share of the memory: the halo of these boxes is 7 %, and alignment costs at most a sixteenth.
TEST_P(PopulationsOf, TakeLittleMoreThanTheirNumbers) {
  const auto bytes_over_own = [](int cells_along_x) {
    const Index3 box(cells_along_x, 80, 80);
    const double own = 19.0 * static_cast<double>(bytes_per_population(GetParam())) * box.prod();
    return static_cast<double>(Populations::bytes_of(box, GetParam(), HaloContent::entering)) / own;
  };
  EXPECT_LT(bytes_over_own(126), 1.075);  // needs no padding
  for (const int cells_along_x : {113, 120, 128, 131})
    EXPECT_LT(bytes_over_own(cells_along_x), 1.075 * 17 / 16);
}

}  // namespace
}  // namespace beadswim
