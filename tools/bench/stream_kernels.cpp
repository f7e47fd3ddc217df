// This file is compiled once per instruction set. BEADSWIM_INSTRUCTION_SET is the name of the namespace.
#include "stream_kernels.hpp"

#include "beadswim/core/kernel.hpp"

namespace beadswim::BEADSWIM_INSTRUCTION_SET {

template <class Real>
BEADSWIM_KERNEL void stream_cells(const StreamRow<Real>& r, long first, long end) {
#pragma GCC ivdep
  for (long x = first; x < end; ++x) {
    Real f[d3q19::directions];
#pragma GCC unroll 19
    for (int i = 0; i < d3q19::directions; ++i) f[i] = r.rows[i][x];
#pragma GCC unroll 19
    for (int i = 0; i < d3q19::directions; ++i) r.rows[d3q19::opposite(i)][x] = f[i];
  }
}

/// Loads and stores all cells of a row. Prefetches six cache lines ahead, as the time step of the solver
/// does. Without prefetching, this yardstick would be slower than the memory allows.
template <class Real>
void stream(const StreamRow<Real>& row) {
  const StreamRow<Real> r = row;
  constexpr long line = 64 / sizeof(Real), lines_ahead = 6;
  const long cells_in_full_lines = r.cells / line * line;
  for (long x = 0; x < cells_in_full_lines; x += line) {
#pragma GCC unroll 19
    for (int i = 0; i < d3q19::directions; ++i) __builtin_prefetch(r.rows[i] + x + lines_ahead * line, 1);
    stream_cells(r, x, x + line);
  }
  stream_cells(r, cells_in_full_lines, r.cells);
}

void copy(const double* from, double* to, long numbers) {
#pragma GCC ivdep
  for (long k = 0; k < numbers; ++k) to[k] = from[k];
}

void scale_in_place(double* numbers, long count, double factor) {
  for (long k = 0; k < count; ++k) numbers[k] *= factor;
}

}  // namespace beadswim::BEADSWIM_INSTRUCTION_SET

namespace beadswim {

const StreamKernels StreamKernels::BEADSWIM_INSTRUCTION_SET{
    BEADSWIM_INSTRUCTION_SET::stream, BEADSWIM_INSTRUCTION_SET::stream, BEADSWIM_INSTRUCTION_SET::copy,
    BEADSWIM_INSTRUCTION_SET::scale_in_place};

}  // namespace beadswim
