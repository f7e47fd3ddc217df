// Compiled once for each instruction set, with BEADSWIM_INSTRUCTION_SET naming the namespace (CMakeLists.txt).
// No function outside that namespace may be emitted from here: the linker could give an AVX-512 copy of it to
// everybody.
#include "row_kernels.hpp"

#include "beadswim/core/order_free_cut.hpp"
#include "beadswim/lattice/moments.hpp"
#include "beadswim/lattice/trt.hpp"

namespace beadswim::BEADSWIM_INSTRUCTION_SET {

/// Cells [first, end) of a row.
template <class Real>
BEADSWIM_KERNEL void sweep_cells(const SweepRow<Real>& r, const CollisionRates<Real>& rates, long first, long end) {
#pragma GCC ivdep
  for (long x = first; x < end; ++x) {
    Real f[d3q19::directions];
#pragma GCC unroll 19
    for (int i = 0; i < d3q19::directions; ++i) f[i] = r.from[i][x];
    collide_trt(f, rates);
#pragma GCC unroll 19
    for (int i = 0; i < d3q19::directions; ++i) r.to[i][x] = f[i];
  }
}

/// Cache lines after which the memory is asked for each stream's next: 19 streams are more than processors
/// follow well by themselves. Measured: +14 % out of cache.
constexpr long lines_ahead = 6;

template <class Real>
BEADSWIM_KERNEL void sweep(const SweepRow<Real>& row) {
  SweepRow<Real> r;  // a copy, which the stores below cannot change
  for (int i = 0; i < d3q19::directions; ++i) r.from[i] = row.from[i] + row.first;
  for (int i = 0; i < d3q19::directions; ++i) r.to[i] = row.to[i] + row.first;
  const CollisionRates<Real> rates = row.rates;
  constexpr long line = 64 / sizeof(Real);
  const long cells = row.cells, whole_lines = cells / line * line;
  for (long x = 0; x < whole_lines; x += line) {
#pragma GCC unroll 19
    for (int i = 0; i < d3q19::directions; ++i) __builtin_prefetch(r.from[i] + x + lines_ahead * line, 1);
    sweep_cells(r, rates, x, x + line);
  }
  sweep_cells(r, rates, whole_lines, cells);
}

void sweep_row(const SweepRow<double>& row) {
  sweep(row);
}
void sweep_row(const SweepRow<float>& row) {
  sweep(row);
}

BEADSWIM_KERNEL double absolute(double x) {
  return x < 0 ? -x : x;
}

template <class Real>
BEADSWIM_KERNEL RowTotals totals(const TotalsRow<Real>& row) {
  using namespace order_free;
  double c0 = 0, c1 = 0, c2 = 0, c3 = 0, f0 = 0, f1 = 0, f2 = 0, f3 = 0;
  long fitting = 0;
#pragma omp simd reduction(+ : c0, c1, c2, c3, f0, f1, f2, f3, fitting)
  for (long x = 0; x < row.cells; ++x) {
    double f[d3q19::directions];
#pragma GCC unroll 19
    for (int i = 0; i < d3q19::directions; ++i) f[i] = static_cast<double>(row.outgoing[i][x]);
    double r, u[3];
    moments_of(f, r, u);
    const double k0 = coarse_part(r), k1 = coarse_part(u[0]), k2 = coarse_part(u[1]), k3 = coarse_part(u[2]);
    c0 += k0, c1 += k1, c2 += k2, c3 += k3;
    f0 += fine_part(r, k0), f1 += fine_part(u[0], k1), f2 += fine_part(u[1], k2), f3 += fine_part(u[2], k3);
    const double size = absolute(r) + absolute(u[0]) + absolute(u[1]) + absolute(u[2]);
    fitting += size < largest_term ? 1 : 0;  // not if a term is not a number
  }
  return {{c0, c1, c2, c3}, {f0, f1, f2, f3}, fitting == row.cells};
}

RowTotals totals_row(const TotalsRow<double>& row) {
  return totals(row);
}
RowTotals totals_row(const TotalsRow<float>& row) {
  return totals(row);
}

}  // namespace beadswim::BEADSWIM_INSTRUCTION_SET
