#pragma once

#include "beadswim/lattice/body_force.hpp"
#include "beadswim/lattice/d3q19.hpp"
#include "beadswim/lattice/trt.hpp"

// Loops over the cells of one row. row_kernels.cpp is compiled once per instruction set.

namespace beadswim {

/// Arguments of one fluid step in a row of cells.
template <class Real>
struct SweepRow {
  /// Addresses of the incoming populations of the cell with index 0, one per direction. Each cell writes to
  /// the same 19 addresses that it reads, and no others.
  Real* incoming[d3q19::directions];
  /// Returns the address to which outgoing population i of the cell with index 0 is written: that of the
  /// incoming population of the opposite direction (populations.hpp).
  Real* outgoing(int i) const { return incoming[d3q19::opposite(i)]; }
  long first, cells;  ///< index of the first cell of the row; number of cells
  CollisionRates<Real> rates;
  BodyForce<Real> force;
};

/// Arguments of totals_row(), which sums density deviation and momentum over a row of cells.
template <class Real>
struct TotalsRow {
  const Real* outgoing[d3q19::directions];  ///< addresses of the outgoing populations of the first cell
  long cells;                               ///< number of cells, at most order_free::max_terms
};
/// Sums of density deviation and momentum over a row of cells. Each term is split into a coarse and a fine
/// part, so that the sums do not depend on the order of the terms (OrderFreeSum).
struct RowTotals {
  double coarse[4], fine[4];  ///< sums of density deviation and of the three momentum components
  bool fits;                  ///< false if a term was too large or NaN; the sums are then invalid
};

/// Kernels compiled for one instruction set.
struct RowKernels {
  void (*sweep_fp64)(const SweepRow<double>&);
  void (*sweep_fp32)(const SweepRow<float>&);
  RowTotals (*totals_fp64)(const TotalsRow<double>&);
  RowTotals (*totals_fp32)(const TotalsRow<float>&);
  const char* instruction_set;  ///< name

  void sweep(const SweepRow<double>& row) const { sweep_fp64(row); }
  void sweep(const SweepRow<float>& row) const { sweep_fp32(row); }
  RowTotals totals(const TotalsRow<double>& row) const { return totals_fp64(row); }
  RowTotals totals(const TotalsRow<float>& row) const { return totals_fp32(row); }

  static const RowKernels baseline, x86_64_v3,
      x86_64_v4;  ///< of each instruction set (core/kernel_choice.hpp)
};

}  // namespace beadswim
