#pragma once

#include "beadswim/lattice/d3q19.hpp"

// Kernels that load and store memory without arithmetic, as upper bounds of the speed of the solver. The file
// stream_kernels.cpp is compiled once per instruction set.

namespace beadswim {

/// One row of `cells` cells in 19 arrays, one array per direction of D3Q19.
template <class Real>
struct StreamRow {
  Real* rows[d3q19::directions];
  long cells;
};

/// The kernels of one instruction set.
struct StreamKernels {
  /// Loads the 19 numbers of each cell, and stores each number in the array of the opposite direction. This
  /// is the memory traffic of a time step that needs only one copy of the lattice (in-place streaming).
  void (*stream_row_fp64)(const StreamRow<double>&);
  void (*stream_row_fp32)(const StreamRow<float>&);
  void (*copy)(const double*, double*, long);
  void (*scale_in_place)(double*, long, double);

  void stream_row(const StreamRow<double>& row) const { stream_row_fp64(row); }
  void stream_row(const StreamRow<float>& row) const { stream_row_fp32(row); }

  static const StreamKernels baseline, x86_64_v3,
      x86_64_v4;  ///< of each instruction set (core/kernel.hpp)
};

}  // namespace beadswim
