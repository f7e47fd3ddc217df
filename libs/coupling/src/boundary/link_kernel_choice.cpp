#include "beadswim/core/kernel_choice.hpp"
#include "link_kernel.hpp"

namespace beadswim {

const LinkKernels& link_kernels() {
  static const LinkKernels chosen = BEADSWIM_BEST_KERNELS(BEADSWIM_LINK_KERNELS);
  return chosen;
}

}  // namespace beadswim
