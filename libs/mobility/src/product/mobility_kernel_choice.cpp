#include "mobility_kernels.hpp"

namespace beadswim {

const MobilityKernels& mobility_kernels() {
#define BEADSWIM_MOBILITY_KERNELS_OF(set)                                             \
  MobilityKernels {                                                                   \
    set::near_spheres, set::pair_velocities, set::spread_windows, set::gather_windows \
  }
  static const MobilityKernels kernels = BEADSWIM_BEST_KERNELS(BEADSWIM_MOBILITY_KERNELS_OF);
  return kernels;
}

}  // namespace beadswim
