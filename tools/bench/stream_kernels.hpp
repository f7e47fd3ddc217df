#pragma once

#include "beadswim/lattice/d3q19.hpp"

// Kernels that load and store memory without arithmetic, as upper bounds of the speed of the solver. The file
// stream_kernels.cpp is compiled once per instruction set; stream_kernels() chooses the best instruction set
// at run time.

namespace beadswim {

/// One row of `cells` cells in 19 arrays, one array per direction of D3Q19.
template <class Real>
struct StreamRow {
  Real* rows[d3q19::directions];
  long cells;
};

#define BEADSWIM_DECLARE_STREAM_KERNELS(instruction_set)           \
  namespace instruction_set {                                      \
  void stream_row_fp64(const StreamRow<double>& row);              \
  void stream_row_fp32(const StreamRow<float>& row);               \
  void copy(const double* from, double* to, long numbers);         \
  void scale_in_place(double* numbers, long count, double factor); \
  }

BEADSWIM_DECLARE_STREAM_KERNELS(baseline)
#if defined(__x86_64__)
BEADSWIM_DECLARE_STREAM_KERNELS(x86_64_v3)
BEADSWIM_DECLARE_STREAM_KERNELS(x86_64_v4)
#endif

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
};

/// Returns the kernels of the best instruction set that this processor supports.
const StreamKernels& stream_kernels();

}  // namespace beadswim
