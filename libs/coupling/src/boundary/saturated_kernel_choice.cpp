#include "beadswim/core/kernel_choice.hpp"
#include "saturated_kernel.hpp"

namespace beadswim {

#define BEADSWIM_SATURATED_KERNELS(set) (SaturatedKernels{set::push_cells, set::push_cells})

const SaturatedKernels& saturated_kernels() {
  static const SaturatedKernels chosen = BEADSWIM_BEST_KERNELS(BEADSWIM_SATURATED_KERNELS);
  return chosen;
}

}  // namespace beadswim
