// Compiled once for each instruction set, with BEADSWIM_SWEEP_ROW naming the function (CMakeLists.txt). No
// other function may be emitted from here: the linker could give an AVX-512 copy of it to everybody.
#include "sweep_row.hpp"

namespace beadswim {

void BEADSWIM_SWEEP_ROW(const SweepRow& row) {
  const long cells = row.cells;
  const double rate_plus = row.rates.symmetric;
  const double rate_minus = row.rates.antisymmetric;
#define BEADSWIM_STREAM(i)                   \
  const double* const from##i = row.from[i]; \
  double* const to##i = row.to[i];
  BEADSWIM_STREAM(0)
  BEADSWIM_STREAM(1) BEADSWIM_STREAM(2) BEADSWIM_STREAM(3) BEADSWIM_STREAM(4) BEADSWIM_STREAM(5)
      BEADSWIM_STREAM(6) BEADSWIM_STREAM(7) BEADSWIM_STREAM(8) BEADSWIM_STREAM(9) BEADSWIM_STREAM(10)
          BEADSWIM_STREAM(11) BEADSWIM_STREAM(12) BEADSWIM_STREAM(13) BEADSWIM_STREAM(14) BEADSWIM_STREAM(15)
              BEADSWIM_STREAM(16) BEADSWIM_STREAM(17) BEADSWIM_STREAM(18)
#undef BEADSWIM_STREAM
#pragma GCC ivdep
                  for (long x = 0; x < cells; ++x) {
    double f[d3q19::directions] = {from0[x],  from1[x],  from2[x],  from3[x],  from4[x],
                                   from5[x],  from6[x],  from7[x],  from8[x],  from9[x],
                                   from10[x], from11[x], from12[x], from13[x], from14[x],
                                   from15[x], from16[x], from17[x], from18[x]};
    collide_trt(f, rate_plus, rate_minus);
    to0[x] = f[0];
    to1[x] = f[1];
    to2[x] = f[2];
    to3[x] = f[3];
    to4[x] = f[4];
    to5[x] = f[5];
    to6[x] = f[6];
    to7[x] = f[7];
    to8[x] = f[8];
    to9[x] = f[9];
    to10[x] = f[10];
    to11[x] = f[11];
    to12[x] = f[12];
    to13[x] = f[13];
    to14[x] = f[14];
    to15[x] = f[15];
    to16[x] = f[16];
    to17[x] = f[17];
    to18[x] = f[18];
  }
}

}  // namespace beadswim
