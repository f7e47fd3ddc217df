#include "row_kernels.hpp"

namespace beadswim {
namespace {

#define BEADSWIM_ROW_KERNELS(set, name)                                    \
  RowKernels {                                                             \
    set::sweep_row, set::sweep_row, set::totals_row, set::totals_row, name \
  }

RowKernels choose() {
#if defined(__x86_64__)
  if (__builtin_cpu_supports("x86-64-v4")) return BEADSWIM_ROW_KERNELS(x86_64_v4, "x86-64-v4");
  if (__builtin_cpu_supports("x86-64-v3")) return BEADSWIM_ROW_KERNELS(x86_64_v3, "x86-64-v3");
#endif
  return BEADSWIM_ROW_KERNELS(baseline, "baseline");
}

}  // namespace

const RowKernels& row_kernels() {
  static const RowKernels chosen = choose();
  return chosen;
}

}  // namespace beadswim
