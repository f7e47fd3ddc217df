#include "beadswim/coupling/force_delay.hpp"

#include "beadswim/lattice/trt.hpp"

namespace beadswim {

double delay_density(const Bead& bead, double relaxation_time) {
  return 4.5 * lattice_viscosity(relaxation_time) * force_delay(relaxation_time) /
         (bead.radius * bead.radius);
}

Bead with_delay_correction(Bead bead, double relaxation_time) {
  bead.density += delay_density(bead, relaxation_time);
  return bead;
}

}  // namespace beadswim
