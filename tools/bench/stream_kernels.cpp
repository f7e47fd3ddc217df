// Compiled once for each instruction set, with BEADSWIM_INSTRUCTION_SET naming the namespace.
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

/// Asks for memory ahead as the solver's sweep does: without, the yardstick would be too short.
template <class Real>
BEADSWIM_KERNEL void stream(const StreamRow<Real>& row) {
  const StreamRow<Real> r = row;
  constexpr long line = 64 / sizeof(Real), lines_ahead = 6;
  const long whole_lines = r.cells / line * line;
  for (long x = 0; x < whole_lines; x += line) {
#pragma GCC unroll 19
    for (int i = 0; i < d3q19::directions; ++i) __builtin_prefetch(r.rows[i] + x + lines_ahead * line, 1);
    stream_cells(r, x, x + line);
  }
  stream_cells(r, whole_lines, r.cells);
}

void stream_row_fp64(const StreamRow<double>& row) {
  stream(row);
}
void stream_row_fp32(const StreamRow<float>& row) {
  stream(row);
}

void copy(const double* from, double* to, long numbers) {
#pragma GCC ivdep
  for (long k = 0; k < numbers; ++k) to[k] = from[k];
}

void scale_in_place(double* numbers, long count, double factor) {
  for (long k = 0; k < count; ++k) numbers[k] *= factor;
}

}  // namespace beadswim::BEADSWIM_INSTRUCTION_SET
