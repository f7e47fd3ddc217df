// This file is compiled once per instruction set; BEADSWIM_INSTRUCTION_SET is the namespace (CMakeLists.txt).
// It must not emit functions outside this namespace. The linker keeps only one copy of such a function and
// could keep the AVX-512 copy, which other processors cannot execute.
#include "row_kernels.hpp"

#include "beadswim/core/kernel.hpp"

namespace beadswim::BEADSWIM_INSTRUCTION_SET {

/// Streams and collides the cells [first, end) of a row; `forced`: the body force acts.
template <bool forced, class Real>
BEADSWIM_KERNEL void sweep_cells(const SweepRow<Real>& r, const CollisionRates<Real>& rates,
                                 const BodyForce<Real>& force, long first, long end) {
#pragma GCC ivdep
  for (long x = first; x < end; ++x) {
    Real f[d3q19::directions];
#pragma GCC unroll 19
    for (int i = 0; i < d3q19::directions; ++i) f[i] = r.incoming[i][x];
    collide_trt(f, rates);
    if constexpr (forced) add_body_force(f, force);
#pragma GCC unroll 19
    for (int i = 0; i < d3q19::directions; ++i) r.outgoing(i)[x] = f[i];
  }
}

/// Distance from the cell that is swept to the populations that are prefetched [cache line]. Hardware
/// prefetchers do not follow 19 arrays well. Compared with a sweep without this prefetch, the cell updates
/// per second increased by 14 % for lattices that do not fit into the cache.
constexpr long lines_ahead = 6;

template <bool forced, class Real>
BEADSWIM_KERNEL void sweep_whole_row(const SweepRow<Real>& row) {
  SweepRow<Real> r;  // a copy, because the compiler must assume that the stores below change `row`
  for (int i = 0; i < d3q19::directions; ++i) r.incoming[i] = row.incoming[i] + row.first;
  const CollisionRates<Real> rates = row.rates;
  const BodyForce<Real> force = row.force;
  constexpr long line = 64 / sizeof(Real);
  const long cells = row.cells, whole_lines = cells / line * line;
  for (long x = 0; x < whole_lines; x += line) {
#pragma GCC unroll 19
    for (int i = 0; i < d3q19::directions; ++i) __builtin_prefetch(r.incoming[i] + x + lines_ahead * line, 1);
    sweep_cells<forced>(r, rates, force, x, x + line);
  }
  sweep_cells<forced>(r, rates, force, whole_lines, cells);
}

template <class Real>
void sweep_row(const SweepRow<Real>& row) {
  row.force.acts ? sweep_whole_row<true>(row) : sweep_whole_row<false>(row);
}

template <class Real>
bool add_totals(const TotalsRow<Real>& row, OrderFreeLanes<4>& sums) {
  order_free::LaneSums<4> partial(sums);
  for (long x = 0; x < row.cells; x += lanes) {
    Lanes f[d3q19::directions], density_deviation, u[3];
    if (row.cells - x >= lanes) {
#pragma GCC unroll 19
      for (int i = 0; i < d3q19::directions; ++i) f[i] = load(row.outgoing[i] + x);
    } else {
      for (int i = 0; i < d3q19::directions; ++i) {
        f[i] = Lanes{};
        for (long k = 0; x + k < row.cells; ++k) f[i][k] = static_cast<double>(row.outgoing[i][x + k]);
      }
    }
    moments_of(f, density_deviation, u);
    partial.add(0, density_deviation);
#pragma GCC unroll 3
    for (int a = 0; a < 3; ++a) partial.add(1 + a, u[a]);
  }
  return partial.store_in(sums);
}

constexpr const char *baseline = "baseline", *x86_64_v3 = "x86-64-v3", *x86_64_v4 = "x86-64-v4";

}  // namespace beadswim::BEADSWIM_INSTRUCTION_SET

namespace beadswim {

const RowKernels RowKernels::BEADSWIM_INSTRUCTION_SET{
    .sweep_fp64 = BEADSWIM_INSTRUCTION_SET::sweep_row,
    .sweep_fp32 = BEADSWIM_INSTRUCTION_SET::sweep_row,
    .totals_fp64 = BEADSWIM_INSTRUCTION_SET::add_totals,
    .totals_fp32 = BEADSWIM_INSTRUCTION_SET::add_totals,
    .instruction_set = BEADSWIM_INSTRUCTION_SET::BEADSWIM_INSTRUCTION_SET};

}  // namespace beadswim
