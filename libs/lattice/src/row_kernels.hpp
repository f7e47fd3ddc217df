#pragma once

#include "beadswim/core/order_free_lanes.hpp"
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

/// A row of cells whose density deviations and momenta are summed.
template <class Real>
struct TotalsRow {
  static constexpr int max_cells = 512;

  const Real* outgoing[d3q19::directions];  ///< addresses of the outgoing populations of the first cell
  long cells;                               ///< number of cells, at most max_cells
};

/// Kernels compiled for one instruction set.
struct RowKernels {
  void (*sweep_fp64)(const SweepRow<double>&);
  void (*sweep_fp32)(const SweepRow<float>&);
  bool (*totals_fp64)(const TotalsRow<double>&, OrderFreeLanes<4>&);
  bool (*totals_fp32)(const TotalsRow<float>&, OrderFreeLanes<4>&);
  const char* instruction_set;  ///< name

  void sweep(const SweepRow<double>& row) const { sweep_fp64(row); }
  void sweep(const SweepRow<float>& row) const { sweep_fp32(row); }
  /// Adds density deviation and momentum of the cells to the sums. If a term is too large or non-finite, adds
  /// nothing and returns false.
  bool add_totals(const TotalsRow<double>& row, OrderFreeLanes<4>& sums) const {
    return totals_fp64(row, sums);
  }
  bool add_totals(const TotalsRow<float>& row, OrderFreeLanes<4>& sums) const {
    return totals_fp32(row, sums);
  }

  static const RowKernels baseline, x86_64_v3,
      x86_64_v4;  ///< of each instruction set (core/kernel.hpp)
};

}  // namespace beadswim
