#pragma once

#include "beadswim/lattice/d3q19.hpp"
#include "beadswim/lattice/trt.hpp"

// What is done to all cells, one row of them at a time. row_kernels.cpp is compiled once for each instruction
// set; row_kernels() chooses at run time.

namespace beadswim {

/// A step of the fluid in a row of cells.
template <class Real>
struct SweepRow {
  const Real* from[d3q19::directions];  ///< cell 0's incoming population of each direction
  Real* to[d3q19::directions];  ///< where cell 0's population goes after collision; the 19 places that a cell
                                ///< reads are those that it writes, and no other cell's
  long first, cells;            ///< the row
  CollisionRates<Real> rates;
};

/// The sums of density deviation and momentum over a row of cells, cut as OrderFreeSum cuts them.
template <class Real>
struct TotalsRow {
  const Real* outgoing[d3q19::directions];  ///< of the first cell
  long cells;                               ///< at most order_free::most_terms
};
struct RowTotals {
  double coarse[4], fine[4];  ///< of density deviation and the three momenta
  bool fits;                  ///< every term was small enough; if not, the sums mean nothing
};

#define BEADSWIM_DECLARE_ROW_KERNELS(instruction_set) \
  namespace instruction_set {                         \
  template <class Real>                               \
  void sweep_row(const SweepRow<Real>& row);          \
  template <class Real>                               \
  RowTotals totals_row(const TotalsRow<Real>& row);   \
  }

BEADSWIM_DECLARE_ROW_KERNELS(baseline)
#if defined(__x86_64__)
BEADSWIM_DECLARE_ROW_KERNELS(x86_64_v3)
BEADSWIM_DECLARE_ROW_KERNELS(x86_64_v4)
#endif

/// The kernels for one instruction set.
struct RowKernels {
  void (*sweep_fp64)(const SweepRow<double>&);
  void (*sweep_fp32)(const SweepRow<float>&);
  RowTotals (*totals_fp64)(const TotalsRow<double>&);
  RowTotals (*totals_fp32)(const TotalsRow<float>&);
  const char* instruction_set;

  void sweep(const SweepRow<double>& row) const { sweep_fp64(row); }
  void sweep(const SweepRow<float>& row) const { sweep_fp32(row); }
  RowTotals totals(const TotalsRow<double>& row) const { return totals_fp64(row); }
  RowTotals totals(const TotalsRow<float>& row) const { return totals_fp32(row); }
};

/// The best that this processor can run.
const RowKernels& row_kernels();

}  // namespace beadswim
