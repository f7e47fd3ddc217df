#include "beadswim/core/kernel_choice.hpp"
#include "row_kernels.hpp"

namespace beadswim {

#define BEADSWIM_ROW_KERNELS(set)             \
  (RowKernels{.sweep_fp64 = set::sweep_row,   \
              .sweep_fp32 = set::sweep_row,   \
              .totals_fp64 = set::totals_row, \
              .totals_fp32 = set::totals_row, \
              .instruction_set = instruction_set_name::set})

const RowKernels& row_kernels() {
  static const RowKernels chosen = BEADSWIM_BEST_KERNELS(BEADSWIM_ROW_KERNELS);
  return chosen;
}

}  // namespace beadswim
