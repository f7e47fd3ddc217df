#include "beadswim/lattice/populations.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <set>

namespace beadswim {
namespace {

/// A row that is not a whole number of cache lines, and a box without symmetry.
const Index3 size(9, 5, 4);

// The table of docs/method/in-place-streaming.md from outside. Catches a parity that is not switched, and a
// shift with the wrong sign.
TEST(Populations, IncomingIsTheNeighboursOutgoingAtEitherParity) {
  Populations populations(size);
  for (int parity = 0; parity < 2; ++parity, populations.advance()) {
    for (int i = 0; i < d3q19::directions; ++i) {
      const auto& c = d3q19::velocity[i];
      const std::ptrdiff_t cell = populations.cell(3, 2, 1);
      const std::ptrdiff_t neighbour = populations.cell(3 - c[0], 2 - c[1], 1 - c[2]);
      EXPECT_EQ(&populations.incoming(i, cell), &populations.outgoing(i, neighbour)) << i;
    }
  }
}

// What makes any order of cells right: a step writes where its own cell has read, and nowhere else.
TEST(Populations, ACellsNextPlacesAreThoseOfItsIncomingOnes) {
  Populations populations(size);
  for (int parity = 0; parity < 2; ++parity, populations.advance()) {
    std::set<const double*> all;
    for_each_cell(populations, [&](const Index3&, std::ptrdiff_t cell) {
      std::set<const double*> read, written;
      for (int i = 0; i < d3q19::directions; ++i) {
        read.insert(&populations.incoming(i, cell));
        written.insert(populations.next_outgoing(i, cell));
      }
      EXPECT_EQ(read, written);
      all.insert(read.begin(), read.end());
    });
    EXPECT_EQ(all.size(), std::size_t(size.prod()) * d3q19::directions);
  }
}

// The numbers themselves: what a step puts down is what the accessors read after it.
TEST(Populations, NextOutgoingIsOutgoingAfterTheStep) {
  Populations populations(size);
  const std::ptrdiff_t cell = populations.cell(0, 4, 3);
  for (int parity = 0; parity < 2; ++parity) {
    for (int i = 0; i < d3q19::directions; ++i) *populations.next_outgoing(i, cell) = i + 0.5;
    populations.advance();
    for (int i = 0; i < d3q19::directions; ++i) EXPECT_EQ(populations.outgoing(i, cell), i + 0.5);
  }
}

TEST(Populations, RowsBeginAtCacheLines) {
  Populations populations(size);
  for (const Index3& row : {Index3(0, 0, 0), Index3(0, 3, 1), Index3(0, 4, 3)}) {
    EXPECT_EQ(reinterpret_cast<std::uintptr_t>(&populations.outgoing(0, populations.cell(row))) % 64, 0u);
  }
}

}  // namespace
}  // namespace beadswim
