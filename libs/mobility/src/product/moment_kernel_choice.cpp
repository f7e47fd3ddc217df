#include "moment_kernels.hpp"

namespace beadswim {

const MomentKernels& moment_kernels() {
#define BEADSWIM_MOMENT_KERNELS_OF(set)                                                     \
  MomentKernels {                                                                           \
    .moment_pairs = set::moment_pairs, .mirror_flow = set::mirror_flow,                     \
    .gather_mirror_flows = set::gather_mirror_flows, .spread_moments = set::spread_moments, \
    .gather_moments = set::gather_moments                                                   \
  }
  static const MomentKernels kernels = BEADSWIM_BEST_KERNELS(BEADSWIM_MOMENT_KERNELS_OF);
  return kernels;
}

}  // namespace beadswim
