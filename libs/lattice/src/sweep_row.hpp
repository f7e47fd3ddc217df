#pragma once

#include "beadswim/lattice/d3q19.hpp"
#include "beadswim/lattice/trt.hpp"

// The bulk kernel: one row of cells. sweep_row.cpp is compiled once for each instruction set.

namespace beadswim {

struct SweepRow {
  const double* from[d3q19::directions];  ///< first cell's incoming population of each direction
  double* to[d3q19::directions];  ///< where the first cell's population goes after collision; the 19 places
                                  ///< that a cell reads are those that it writes, and no other cell's
  long cells;
  RelaxationRates rates;
};

void sweep_row_baseline(const SweepRow& row);
#if defined(__x86_64__)
void sweep_row_v3(const SweepRow& row);
void sweep_row_v4(const SweepRow& row);
#endif

}  // namespace beadswim
