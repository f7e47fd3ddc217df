#include "mobility_kernels.hpp"

namespace beadswim {

const MobilityKernels& mobility_kernels() {
#define BEADSWIM_MOBILITY_KERNELS_OF(set)                                                 \
  MobilityKernels {                                                                       \
    .find_near_spheres = set::find_near_spheres, .pair_velocities = set::pair_velocities, \
    .spread_windows = set::spread_windows, .gather_windows = set::gather_windows,         \
    .multiply_waves = set::multiply_waves                                                 \
  }
  static const MobilityKernels kernels = BEADSWIM_BEST_KERNELS(BEADSWIM_MOBILITY_KERNELS_OF);
  return kernels;
}

}  // namespace beadswim
