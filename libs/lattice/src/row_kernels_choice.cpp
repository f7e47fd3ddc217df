#include "beadswim/core/kernel_choice.hpp"
#include "row_kernels.hpp"

namespace beadswim {

#define BEADSWIM_ROW_KERNELS(set) \
  (RowKernels{set::sweep_row, set::sweep_row, set::totals_row, set::totals_row, instruction_set_name::set})

const RowKernels& row_kernels() {
  static const RowKernels chosen = BEADSWIM_BEST_KERNELS(BEADSWIM_ROW_KERNELS);
  return chosen;
}

}  // namespace beadswim
