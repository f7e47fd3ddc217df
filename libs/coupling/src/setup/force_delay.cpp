#include "beadswim/coupling/force_delay.hpp"

#include "beadswim/lattice/trt.hpp"

namespace beadswim {

Bead with_delay_correction(Bead bead, double relaxation_time) {
  bead.density +=
      4.5 * lattice_viscosity(relaxation_time) * force_delay(relaxation_time) / (bead.radius * bead.radius);
  return bead;
}

}  // namespace beadswim
