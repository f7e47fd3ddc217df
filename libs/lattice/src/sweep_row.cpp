// Compiled once for each instruction set, with BEADSWIM_SWEEP_ROW naming the function (CMakeLists.txt). No
// other function may be emitted from here: the linker could give an AVX-512 copy of it to everybody.
#include "sweep_row.hpp"

namespace beadswim {

void BEADSWIM_SWEEP_ROW(const SweepRow& row) {
  const SweepRow r = row;  // a copy, which the stores below cannot change
#pragma GCC ivdep
  for (long x = 0; x < r.cells; ++x) {
    double f[d3q19::directions];
#pragma GCC unroll 19
    for (int i = 0; i < d3q19::directions; ++i) f[i] = r.from[i][x];
    collide_trt(f, r.rates.symmetric, r.rates.antisymmetric);
#pragma GCC unroll 19
    for (int i = 0; i < d3q19::directions; ++i) r.to[i][x] = f[i];
  }
}

}  // namespace beadswim
