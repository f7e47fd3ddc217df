#include "beadswim/core/kernel_choice.hpp"
#include "stream_kernels.hpp"

namespace beadswim {

#define BEADSWIM_STREAM_KERNELS(set) \
  (StreamKernels{set::stream_row_fp64, set::stream_row_fp32, set::copy, set::scale_in_place})

const StreamKernels& stream_kernels() {
  static const StreamKernels chosen = BEADSWIM_BEST_KERNELS(BEADSWIM_STREAM_KERNELS);
  return chosen;
}

}  // namespace beadswim
